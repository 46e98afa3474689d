# find_package(hinge): the engine as hinge::engine.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
include(${CMAKE_CURRENT_LIST_DIR}/hingeTargets.cmake)
