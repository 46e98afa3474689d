# find_package(hinge): the engine as hinge::engine; what records its runs as hinge::record.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/hingeTargets.cmake)
