# How every target of Blossom is compiled, and the one way to declare a library, so that each folder's CMakeLists.txt
# only says what it is and what it stands on.

add_library(blossom_flags INTERFACE)
# Never contract a*b+c: the recorded and the unrecorded instantiation of one template must give the same bits.
target_compile_options(blossom_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                               -Wno-sign-conversion)
# g++ 12 sees an overlapping copy in every "text" + std::to_string(n) (GCC bug 105651).
target_compile_options(blossom_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# glm::vec with a class as scalar (the exact rational) needs plain members instead of anonymous unions.
target_compile_definitions(blossom_flags INTERFACE GLM_FORCE_XYZW_ONLY)
target_include_directories(blossom_flags INTERFACE ${PROJECT_SOURCE_DIR}/engine)
if(BLOSSOM_NATIVE)
  target_compile_options(blossom_flags INTERFACE -march=native)
endif()
if(BLOSSOM_WERROR)
  target_compile_options(blossom_flags INTERFACE -Werror)
endif()
if(BLOSSOM_SANITIZE)
  target_compile_options(blossom_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer)
  target_link_options(blossom_flags INTERFACE -fsanitize=address,undefined)
endif()
if(BLOSSOM_FUZZ)
  # Counters for libFuzzer in everything, beside the sanitizers; only the targets themselves get its main.
  target_compile_options(blossom_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# blossom_library(base DEPENDS geometry kernel ...): libblossom_base.a of every *.cpp in this folder. DEPENDS are other
# Blossom folders or CMake targets; they are the only headers-with-code this folder may use.
function(blossom_library name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(blossom_${name} STATIC ${sources})
    set(scope PUBLIC)
  else()
    add_library(blossom_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_link_libraries(blossom_${name} ${scope} blossom_flags ${ARG_LIBRARIES})
  foreach(dependency IN LISTS ARG_DEPENDS)
    target_link_libraries(blossom_${name} ${scope} blossom_${dependency})
  endforeach()
endfunction()

# blossom_table(blossom_algorithms TYPE Algorithm FUNCTION algorithms HEADER algorithms/algorithm.hpp FILES a.cpp b.cpp):
# writes the function that lists what is in FILES, in the order given, into the target. Each FILES entry NAME.cpp defines
# `const TYPE& PREFIX_NAME()`, PREFIX being empty unless given. So a new algorithm, command or report format is one new
# file, and no list anywhere is edited. (Static registrar objects would be dropped by the linker from a static library.)
function(blossom_table target)
  cmake_parse_arguments(ARG "" "TYPE;FUNCTION;HEADER;PREFIX" "FILES" ${ARGN})
  set(declarations "")
  set(entries "")
  foreach(file IN LISTS ARG_FILES)
    get_filename_component(name ${file} NAME_WE)
    string(APPEND declarations "const ${ARG_TYPE}& ${ARG_PREFIX}${name}();\n")
    string(APPEND entries "&${ARG_PREFIX}${name}(), ")
  endforeach()
  set(table ${CMAKE_CURRENT_BINARY_DIR}/${ARG_FUNCTION}_table.cpp)
  file(CONFIGURE OUTPUT ${table} CONTENT [[
#include "@ARG_HEADER@"

namespace blossom {
@declarations@
const std::vector<const @ARG_TYPE@*>& @ARG_FUNCTION@() {
  static const std::vector<const @ARG_TYPE@*> all{@entries@};
  return all;
}
}  // namespace blossom
]] @ONLY)
  target_sources(${target} PRIVATE ${table})
endfunction()

# blossom_texts(target HEADER grader/page/assets.hpp FILES a.css b.js): the files' contents as constants a_css, b_js in
# namespace blossom::assets, in a header of the build folder, so that programs carry what they need with them.
function(blossom_texts target)
  cmake_parse_arguments(ARG "" "HEADER" "FILES" ${ARGN})
  set(constants "")
  foreach(file IN LISTS ARG_FILES)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(name ${file} NAME)
    string(REPLACE "." "_" name ${name})
    string(REPLACE "-" "_" name ${name})
    file(READ ${file} content)
    string(APPEND constants "inline constexpr std::string_view ${name} = R\"blossom(${content})blossom\";\n")
  endforeach()
  set(header ${CMAKE_CURRENT_BINARY_DIR}/texts/${ARG_HEADER})
  file(CONFIGURE OUTPUT ${header} CONTENT "#pragma once\n#include <string_view>\n\nnamespace blossom::assets {\n@constants@}  // namespace blossom::assets\n" @ONLY)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/texts)
endfunction()
