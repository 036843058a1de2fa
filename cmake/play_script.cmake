# cmake -D PROGRAM=blossom -D SCRIPT=tests/play/scripts/NAME.txt -D OUT=FOLDER -P play_script.cmake: plays the script in an
# empty folder with nothing remembered, and fails if the script does.
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT})
execute_process(COMMAND ${PROGRAM} play --headless-script ${SCRIPT} --out ${OUT} --state ${OUT}/state
                RESULT_VARIABLE result)
if(NOT result STREQUAL "0")
  message(FATAL_ERROR "the script ended with ${result}; its pictures so far are in ${OUT}")
endif()
