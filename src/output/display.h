// Connection to an X display that can draw, checked before VTK uses it, because VTK aborts without one.
#pragma once

namespace hinge::output {

/// During its lifetime, an X error is stored and does not end the process.
class CalmX {
public:
    CalmX();
    ~CalmX();
    CalmX(const CalmX&) = delete;
    CalmX& operator=(const CalmX&) = delete;

private:
    void* errors_;
    void* io_errors_;
};

/// The connection (a Display*) for drawing pictures: to DISPLAY if that is local and supports OpenGL 3.2, else to a
/// virtual display. Opened once, and again after a fork or the end of the server; `fresh` is then true.
void* drawing_display(bool& fresh);

/// Sets DISPLAY to a virtual display, unless it names one that answers: for processes that are started from this one.
/// Leaves no connection open, so that they start with none.
void share_display();

/// True if the server still answers.
bool display_alive();

}  // namespace hinge::output
