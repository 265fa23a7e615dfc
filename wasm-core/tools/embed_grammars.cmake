# Writes OUTPUT, a C++ file that holds the text of every grammar in INPUTS by the number that ends its name. A script of
# CMake's, so that a build needs no Node.
set(cases "")
foreach(input IN LISTS INPUTS)
  if(NOT input MATCHES "-([0-9]+)\\.lsys$")
    message(FATAL_ERROR "${input}: the name of a built-in grammar ends in its number, as in grape-bunch-3.lsys")
  endif()
  set(number ${CMAKE_MATCH_1})
  file(READ ${input} text)
  string(APPEND cases "    case ${number}:\n      return R\"lsys(${text})lsys\";\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from grammars/${MODEL}/*.lsys by tools/embed_grammars.cmake.\n\
#include \"models/${MODEL}/builtin_grammars.hpp\"\n\n\
namespace panicle::${MODEL} {\n\n\
std::string_view builtin_grammar(int number) {\n\
  switch (number) {\n\
${cases}\
    default:\n\
      return {};\n\
  }\n\
}\n\n\
}  // namespace panicle::${MODEL}\n")
