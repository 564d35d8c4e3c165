# Our warning flags; errors only where a preset says so (CMAKE_COMPILE_WARNING_AS_ERROR).
add_library(feelem_warnings INTERFACE)
target_compile_options(
    feelem_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast)
