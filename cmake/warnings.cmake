# Our warning flags; errors only where a preset says so (CMAKE_COMPILE_WARNING_AS_ERROR).
add_library(feelem_warnings INTERFACE)
target_compile_options(
    feelem_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast)
# GCC 12 sees overlaps in std::string's operator+ that are not there (its bug 105651).
target_compile_options(feelem_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# In batches a .cpp is included, which GCC takes for a header whose types must not be local.
target_compile_options(
    feelem_warnings INTERFACE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>)
