# FEELEM_SANITIZE=address,undefined | thread, for everything we compile.
if(FEELEM_SANITIZE)
    add_compile_options(-fsanitize=${FEELEM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${FEELEM_SANITIZE})
endif()
