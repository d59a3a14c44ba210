target_sources(adit_core PRIVATE)
