# The command as a WebAssembly module for Node.js, with threads: girth-command.js with its .wasm, and
# girth.cjs, which starts it. Built by name, for the npm package.
list(FILTER sources EXCLUDE REGEX "^(archive/inflate_zlib|process/(forked_jobs|interrupt)_posix)\\.cpp$")
add_executable(girth_command_wasm EXCLUDE_FROM_ALL ${sources})
girth_configure(girth_command_wasm)
girth_unity(girth_command_wasm)
target_compile_options(girth_command_wasm PRIVATE $<$<CONFIG:Release>:-O1>)
target_include_directories(girth_command_wasm PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(girth_command_wasm PRIVATE girth_study_threads girth_io_threads girth_io_internal
                                                 girth_core_threads girth_single_headers)
set(folder "${PROJECT_BINARY_DIR}/command")
# Its files are CommonJS, whatever the package around them is.
file(WRITE "${folder}/package.json" "{ \"type\": \"commonjs\" }\n")
configure_file("${CMAKE_CURRENT_LIST_DIR}/girth.cjs" "${folder}/girth.cjs" COPYONLY)
set(library "${CMAKE_CURRENT_LIST_DIR}/node_library.js")
set_target_properties(girth_command_wasm PROPERTIES OUTPUT_NAME girth-command SUFFIX ".js" LINK_DEPENDS "${library}"
                                                    RUNTIME_OUTPUT_DIRECTORY "${folder}")
target_link_options(
  girth_command_wasm PRIVATE
  -O3 -fwasm-exceptions -pthread
  "SHELL:--js-library \"${library}\""
  -sMODULARIZE=1 -sEXPORT_NAME=createGirthCommand -sENVIRONMENT=node,worker -sNODERAWFS=1
  # main has a thread of its own, so that the first one can start others and hear signals. It starts, and another one,
  # while the module is compiled.
  -sPROXY_TO_PTHREAD=1 -sPTHREAD_POOL_SIZE=2 -sEXIT_RUNTIME=1 -sDEFAULT_PTHREAD_STACK_SIZE=4194304
  "-sEXPORTED_FUNCTIONS=_main,_malloc,_free"
  -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4294967296 -sABORTING_MALLOC=0
  # JavaScript touches the memory only to read and write files.
  -Wno-pthreads-mem-growth)
