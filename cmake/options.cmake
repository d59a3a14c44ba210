# What every target of adit is compiled with. Links privately: nothing of it reaches a project that uses ours.
add_library(adit_options INTERFACE)
target_compile_features(adit_options INTERFACE cxx_std_20)
target_compile_options(adit_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  # The same bits on every CPU: no fused multiply-add that the source does not ask for.
  -ffp-contract=off)
if(ADIT_WERROR)
  target_compile_options(adit_options INTERFACE -Werror)
endif()

# Sanitizers must see all of a program, tests and GoogleTest's source too: they are set for this folder and below,
# which is still nothing to a project that includes ours.
if(ADIT_SANITIZE)
  add_compile_options(-fsanitize=${ADIT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ADIT_SANITIZE})
endif()
if(ADIT_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
