// What a shared library of the core shows: the names of the public headers and nothing else.
#pragma once

// On a namespace it holds for all that is declared in it; the rest of the core is compiled with hidden symbols.
#if defined(__GNUC__)
#define ADIT_API [[gnu::visibility("default")]]
#else
#define ADIT_API
#endif
