# cmake --install: the program, the module, the Lua library, and the engine as the CMake package `hinge` (targets hinge::engine, hinge::record).
# The module and the program look for the Lua library and the pictures in these folders, seen from where they lie themselves
# (script/lua/installed_files.cpp), so the whole may be moved.
# Components: program, module, development; the Debian package (package.cmake) takes program and debian.
set(HINGE_MODULE_FOLDER lib/lua/5.4 CACHE STRING "Where the module is installed; on Lua's cpath")
set(HINGE_LIBRARY_FOLDER share/hinge/lua CACHE STRING "Where the Lua library is installed")

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
install(TARGETS hinge_program RUNTIME DESTINATION bin)
install(DIRECTORY lua/hinge DESTINATION ${HINGE_LIBRARY_FOLDER})
if(HINGE_PICTURES)
  install(TARGETS hinge_output LIBRARY DESTINATION lib/hinge)
endif()
install(FILES src/hinge.1 DESTINATION share/man/man1)
install(FILES LICENSE src/CHANGES.md DESTINATION share/doc/hinge)
install(DIRECTORY lua/guide DESTINATION share/doc/hinge)
install(DIRECTORY scripts/ DESTINATION share/doc/hinge/examples FILES_MATCHING PATTERN *.lua
  PATTERN host EXCLUDE PATTERN pictures EXCLUDE PATTERN paper EXCLUDE)
# Completion of the shells, written by the program itself, each where the shell looks for it.
foreach(shell bash fish)
  add_custom_command(OUTPUT completion/hinge.${shell} DEPENDS hinge_program VERBATIM
    COMMAND ${CMAKE_COMMAND} -E make_directory completion
    COMMAND hinge_program completion ${shell} > completion/hinge.${shell})
endforeach()
# The reference of all calls as a page, which the program prints.
file(GLOB_RECURSE words CONFIGURE_DEPENDS lua/hinge/*.d.lua)
add_custom_command(OUTPUT reference.md DEPENDS hinge_program ${words} VERBATIM
  COMMAND hinge_program reference > reference.md)
# The scripts of the guide's pages: the first block of Lua of each.
file(GLOB guide CONFIGURE_DEPENDS lua/guide/*.md)
add_custom_command(OUTPUT guide/grid.lua DEPENDS hinge_program ${guide} lua/guide/pages.lua VERBATIM
  COMMAND ${CMAKE_COMMAND} -E make_directory guide
  COMMAND hinge_program -e "package.path = '${PROJECT_SOURCE_DIR}/lua/guide/?.lua'; require('pages').write_scripts('guide')")
add_custom_target(hinge_completion ALL DEPENDS completion/hinge.bash completion/hinge.fish reference.md guide/grid.lua)
install(DIRECTORY ${PROJECT_BINARY_DIR}/guide DESTINATION share/doc/hinge)
install(FILES ${PROJECT_BINARY_DIR}/reference.md DESTINATION share/doc/hinge)
install(FILES ${PROJECT_BINARY_DIR}/completion/hinge.bash DESTINATION share/bash-completion/completions RENAME hinge)
install(FILES ${PROJECT_BINARY_DIR}/completion/hinge.fish DESTINATION share/fish/vendor_completions.d)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME module)
install(TARGETS hinge_module LIBRARY DESTINATION ${HINGE_MODULE_FOLDER})

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
# Whoever includes the engine's headers compiles them as the engine was compiled: types laid out alike, the same bits.
target_compile_features(hinge_engine INTERFACE cxx_std_20)
target_compile_options(hinge_engine INTERFACE "$<INSTALL_INTERFACE:-Wno-psabi;-ffp-contract=off;-fno-tree-slp-vectorize;$<$<BOOL:${HINGE_NATIVE}>:-march=native>>")
target_compile_definitions(hinge_engine INTERFACE $<INSTALL_INTERFACE:HINGE_ALIGNMENT=${hinge_alignment}>)
target_include_directories(hinge_engine INTERFACE $<INSTALL_INTERFACE:include/hinge>)
target_link_libraries(hinge_engine INTERFACE $<INSTALL_INTERFACE:Eigen3::Eigen>)
set_target_properties(hinge_engine PROPERTIES EXPORT_NAME engine)
set_target_properties(hinge_record PROPERTIES EXPORT_NAME record)

foreach(part core model section beam contact state algebra effects run advice record)
  install(DIRECTORY src/${part} DESTINATION include/hinge FILES_MATCHING PATTERN *.h)
endforeach()
install(FILES src/output/picture.h DESTINATION include/hinge/output)  # record/snapshot.h has its Snapshot
install(TARGETS hinge_engine hinge_record EXPORT hinge ARCHIVE DESTINATION lib)
install(EXPORT hinge NAMESPACE hinge:: FILE hingeTargets.cmake DESTINATION lib/cmake/hinge)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/hingeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES src/hingeConfig.cmake ${CMAKE_BINARY_DIR}/hingeConfigVersion.cmake DESTINATION lib/cmake/hinge)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME debian)
install(TARGETS hinge_module LIBRARY DESTINATION lib/${CMAKE_LIBRARY_ARCHITECTURE}/lua/5.4 EXCLUDE_FROM_ALL)
install(FILES LICENSE DESTINATION share/doc/hinge RENAME copyright EXCLUDE_FROM_ALL)
