# Read by ctest (not by the build): asks a Catch2 program for its test cases and declares each one to ctest as
# "<folder>: <name of the test case>".
#
# Catch2 2's own catch_discover_tests is not used: a name with an unbalanced bracket, such as "u in [0, 1)", swallows
# the names after it, the listing has no time limit, and a name that matches nothing counts as passed.
cmake_minimum_required(VERSION 3.25)

function(discover_tests folder program working_directory)
  execute_process(COMMAND "${program}" --list-test-names-only WORKING_DIRECTORY "${working_directory}" TIMEOUT 60
                  OUTPUT_VARIABLE names ERROR_VARIABLE errors RESULT_VARIABLE result)
  # The exit status is the number of test cases; a text instead of it says that the program did not run to its end.
  # Then, and when there is not one test case, the program itself becomes the test, and fails for all to see.
  if(NOT result MATCHES "^[0-9]+$" OR names STREQUAL "")
    add_test("${folder}" "${program}" "*" --warn NoTests)
    return()
  endif()
  while(names MATCHES "^([^\n]*)\n(.*)$")
    set(name "${CMAKE_MATCH_1}")
    set(names "${CMAKE_MATCH_2}")
    # What means something in a Catch2 test specification is escaped; the backslash first.
    set(specification "${name}")
    foreach(character IN ITEMS "\\" "," "[" "]" "\"" "~")
      string(REPLACE "${character}" "\\${character}" specification "${specification}")
    endforeach()
    add_test("${folder}: ${name}" "${program}" "${specification}" --warn NoTests)
    # Catch2 2 cannot skip: a test that has not what it needs says so, and passes.
    set_tests_properties("${folder}: ${name}" PROPERTIES WORKING_DIRECTORY "${working_directory}" TIMEOUT 300
                         SKIP_REGULAR_EXPRESSION "test skipped: ")
  endwhile()
endfunction()
