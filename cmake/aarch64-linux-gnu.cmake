# Toolchain: 64-bit ARM by Debian's cross compiler (g++-aarch64-linux-gnu); tests run under qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
# Libraries and packages of this machine's own kind are of no use there.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_FIND_ROOT_PATH /usr/aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64;-L;/usr/aarch64-linux-gnu)
# For more than the core: -DADIT_AARCH64_SYSROOT=FOLDER, with that machine's libraries (scripts/aarch64_sysroot makes it).
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ADIT_AARCH64_SYSROOT)
if(ADIT_AARCH64_SYSROOT)
  list(PREPEND CMAKE_FIND_ROOT_PATH ${ADIT_AARCH64_SYSROOT})
  set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
  set(library_folder ${ADIT_AARCH64_SYSROOT}/usr/lib/aarch64-linux-gnu)
  # Headers that differ from machine to machine, jconfig.h for one.
  set(CMAKE_CXX_FLAGS_INIT "-isystem ${ADIT_AARCH64_SYSROOT}/usr/include/aarch64-linux-gnu")
  # OpenCV needs hundreds of libraries in its turn; they are there when the program runs.
  set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-rpath-link,${library_folder} -Wl,--allow-shlib-undefined")
  set(ENV{PKG_CONFIG_LIBDIR} ${library_folder}/pkgconfig:${ADIT_AARCH64_SYSROOT}/usr/share/pkgconfig)
  set(ENV{PKG_CONFIG_SYSROOT_DIR} ${ADIT_AARCH64_SYSROOT})
  # Where Debian keeps the two that it lets one choose between.
  set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64;-L;${ADIT_AARCH64_SYSROOT};-E;LD_LIBRARY_PATH=/usr/lib/aarch64-linux-gnu/blas:/usr/lib/aarch64-linux-gnu/lapack)
endif()
