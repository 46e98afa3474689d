// Where the tests find the output module. The path of the build folder is in this file alone, so that the tests
// themselves are compiled alike in every build folder.
namespace hinge::output::test {

extern const char* const output_module_path;
const char* const output_module_path = HINGE_OUTPUT_MODULE;

}  // namespace hinge::output::test
