# What `hinge --version` says of the build. Only version.cpp is compiled with it.
set(processor "portable (HINGE_NATIVE=OFF)")
if(HINGE_NATIVE)
  set(processor "native (-march=native, vectors of ${hinge_alignment} bytes)")
endif()
set_source_files_properties(src/version.cpp PROPERTIES COMPILE_DEFINITIONS "\
HINGE_BUILD=\"${CMAKE_BUILD_TYPE}\";\
HINGE_COMPILER=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\";\
HINGE_PROCESSOR=\"${processor}\";\
HINGE_WATCHED=\"${HINGE_SANITIZE}\";\
HINGE_LUA=\"${LUA_VERSION_STRING}\";\
HINGE_EIGEN=\"${Eigen3_VERSION}\";\
HINGE_VTK=\"${hinge_vtk_version}\"")

# The commit is looked up at every build, and its header written only where it changed: then one file is compiled anew.
add_custom_target(hinge_commit BYPRODUCTS ${CMAKE_BINARY_DIR}/commit/hinge_commit.h
  COMMAND ${CMAKE_COMMAND} -D source=${PROJECT_SOURCE_DIR} -D header=${CMAKE_BINARY_DIR}/commit/hinge_commit.h
  -P ${PROJECT_SOURCE_DIR}/src/commit.cmake)
add_dependencies(hinge_program hinge_commit)
target_include_directories(hinge_program PRIVATE ${CMAKE_BINARY_DIR}/commit)
