# The Debian package, made by scripts/package.sh, or by cpack in any build folder. It holds the program, the module on
# the path of Debian's Lua, the Lua library, pages and examples; not the engine's header files.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hinge)
set(CPACK_PACKAGE_CONTACT "The hinge authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "collapse of framed structures under impact, scripted in Lua")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Beams with plastic hinges, members that break and hit each other, and
an energy balance that says where the energy went. A script in Lua 5.4 declares the structure and runs it,
in the program hinge or under plain Lua with the module of that name.")
if(HINGE_NATIVE)
  string(APPEND CPACK_DEBIAN_PACKAGE_DESCRIPTION "\nBuilt with -march=native: for processors like the builder's.")
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program debian)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # the packages of the shared libraries that are used
# pictures; plots; scripts of OpenSees
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "xvfb, fonts-dejavu-core, libgl1-mesa-dri, gnuplot-nox, tcl, python3")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "lua5.4, ffmpeg")  # ffmpeg: films as MP4 and WebM
include(CPack)
