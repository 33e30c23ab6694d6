# The measured table of README.md and the study's CSV beside this file must agree.
#   cmake -DPROGRAM=thetalane [-DUPDATE=ON] -P readme_table.cmake
# Without UPDATE it only compares, and fails where they differ; with it, the table is written anew.
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(readme "${root}/README.md")
set(begin "<!-- study table: tests/benchmarks/study_throws.csv -->")
set(end "<!-- end of study table -->")

execute_process(
    COMMAND "${PROGRAM}" study --table "${CMAKE_CURRENT_LIST_DIR}/study_throws.csv" --language en
    OUTPUT_VARIABLE table RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} could not print the table")
endif()

file(READ "${readme}" text)
string(FIND "${text}" "${begin}" from)
string(FIND "${text}" "${end}" to)
if(from EQUAL -1 OR to LESS from)
    message(FATAL_ERROR "README.md lacks the marks of the study's table")
endif()
string(LENGTH "${begin}" length)
math(EXPR from "${from} + ${length}")
math(EXPR length "${to} - ${from}")
string(SUBSTRING "${text}" ${from} ${length} found)
set(wanted "\n${table}")
if(UPDATE)
    string(SUBSTRING "${text}" 0 ${from} before)
    string(SUBSTRING "${text}" ${to} -1 after)
    file(WRITE "${readme}" "${before}${wanted}${after}")
elseif(NOT found STREQUAL wanted)
    message(FATAL_ERROR "README.md's table is not that of study_throws.csv; build the target update_study_table")
endif()
