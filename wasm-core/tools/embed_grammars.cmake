# Writes OUTPUT, a C++ file that holds the text of every grammar in INPUTS, each by the name of its file, less its comments
# (line ends stay, so that lines keep their numbers); with VARIANT no_texts the names alone. A script of CMake's, so that a
# build needs no Node.
set(constants "")
foreach(input IN LISTS INPUTS)
  get_filename_component(name ${input} NAME_WE)
  string(REPLACE "-" "_" name ${name})
  file(READ ${input} text)
  # In CMake's lists semicolons and brackets mean something: they wait under other names.
  string(REPLACE ";" "<semicolon>" text "${text}")
  string(REPLACE "[" "<open>" text "${text}")
  string(REPLACE "]" "<close>" text "${text}")
  string(REGEX MATCHALL "/\\*[^*]*\\*+([^/*][^*]*\\*+)*/" comments "${text}")
  foreach(comment IN LISTS comments)
    string(REGEX REPLACE "[^\n]+" "" ends "${comment}")
    string(REPLACE "${comment}" "${ends}" text "${text}")
  endforeach()
  string(REPLACE "<semicolon>" ";" text "${text}")
  string(REPLACE "<open>" "[" text "${text}")
  string(REPLACE "<close>" "]" text "${text}")
  if(VARIANT STREQUAL "no_texts")
    set(text "")
  endif()
  string(REGEX REPLACE " +\n" "\n" text "${text}")
  string(APPEND constants "extern const std::string_view ${name} = R\"lsys(${text})lsys\";\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from grammars/${MODEL}/*.lsys by tools/embed_grammars.cmake.\n\
#include <string_view>\n\n\
namespace panicle::${MODEL}::grammars {\n\n\
${constants}\n\
}  // namespace panicle::${MODEL}::grammars\n")
