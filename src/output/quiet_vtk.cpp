// Redirects VTK's messages from stdout and stderr into our own error messages.
#include "output/quiet_vtk.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <mutex>

namespace hinge::output {
namespace {

std::mutex complaint_guard;
std::string complaint;

class QuietWindow : public vtkOutputWindow {
public:
    static QuietWindow* New();
    vtkTypeMacro(QuietWindow, vtkOutputWindow)

        void DisplayText(const char* text) override {
        keep(text);
    }
    void DisplayErrorText(const char* text) override { keep(text); }
    void DisplayWarningText(const char* text) override { keep(text); }
    void DisplayGenericWarningText(const char* text) override { keep(text); }
    void DisplayDebugText(const char*) override {}

private:
    static void keep(const char* text) {
        const std::lock_guard lock(complaint_guard);
        if (complaint.empty() && text) complaint = text;
    }
};
vtkStandardNewMacro(QuietWindow);

/// VTK writes "ERROR: In file, line n\nvtkClass (0x...): what happened\n\n"; only the last part means anything to a
/// reader.
std::string last_part(const std::string& text) {
    const auto end = text.find_last_not_of(" \n\r");
    if (end == std::string::npos) return {};
    std::string line = text.substr(0, end + 1);
    if (const auto at = line.find("): "); at != std::string::npos) line.erase(0, at + 3);
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    return line;
}

}  // namespace

void silence_vtk() {
    static const bool done = [] {
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
        const vtkNew<QuietWindow> window;
        vtkOutputWindow::SetInstance(window);
        return true;
    }();
    (void)done;
}

std::string take_vtk_complaint() {
    const std::lock_guard lock(complaint_guard);
    std::string text;
    text.swap(complaint);
    return last_part(text);
}

}  // namespace hinge::output
