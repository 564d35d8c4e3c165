# Writes OUTPUT: the files under DIST, compressed, as one table of C++. FALLBACK stands in for a page that was not built.
cmake_minimum_required(VERSION 3.25)
get_filename_component(folder ${OUTPUT} DIRECTORY)
file(REMOVE_RECURSE ${folder}/page)
file(MAKE_DIRECTORY ${folder}/page)
file(GLOB_RECURSE files RELATIVE ${DIST} ${DIST}/*)
list(SORT files)
set(root ${DIST})
if(NOT "index.html" IN_LIST files)
    get_filename_component(root ${FALLBACK} DIRECTORY)
    set(files no_page.html)
endif()

set(bytes "")
set(externs "")
set(rows "")
set(index 0)
foreach(file IN LISTS files)
    set(packed ${folder}/page/${index}.gz)
    execute_process(COMMAND gzip -9 -n -c ${root}/${file} OUTPUT_FILE ${packed} COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX REPLACE "^no_page.html$" "index.html" path ${file})
    string(APPEND bytes
        "asm(\".section .rodata\\n.global feelem_page_${index}\\nfeelem_page_${index}:\\n.incbin \\\"${packed}\\\"\\n\"\n"
        "    \".global feelem_page_${index}_end\\nfeelem_page_${index}_end:\\n.byte 0\\n.previous\\n\");\n")
    string(APPEND externs "extern const std::byte feelem_page_${index}[];\nextern const std::byte feelem_page_${index}_end[];\n")
    string(APPEND rows "        {\"/${path}\", {feelem_page_${index}, feelem_page_${index}_end}},\n")
    math(EXPR index "${index} + 1")
endforeach()

file(WRITE ${OUTPUT}
"// Made by embed_page.cmake.
#include \"page_assets.hpp\"

${bytes}
extern \"C\" {
${externs}}

namespace feelem::server {

std::vector<PageAsset> page_assets() {
    return {
${rows}    };
}

}  // namespace feelem::server
")
