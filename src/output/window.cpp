// The off-screen window that renders all pictures.
#include "output/window.h"

#include <GL/gl.h>
#include <vtkActorCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include "core/errors.h"
#include "output/display.h"
#include "output/quiet_vtk.h"

namespace hinge::output {
namespace {

constexpr int smallest = 64, largest = 8192;

/// Never destroyed: closing it talks to a server that may have gone, and Mesa's own exit may have come first.
vtkRenderWindow* window = nullptr;

void ready_window(int width, int height) {
    bool fresh = false;
    void* display = drawing_display(fresh);
    if (fresh || !window) {
        window = vtkRenderWindow::New();
        window->SetDisplayId(display);
        window->SetShowWindow(false);
        window->SetUseOffScreenBuffers(true);
        window->SwapBuffersOff();
        window->SetMultiSamples(4);
    }
    window->SetSize(width, height);
}

/// Whether nothing in a layer lets shine through what is behind it.
bool is_opaque(vtkRenderer* layer) {
    vtkActorCollection* actors = layer->GetActors();
    if (layer->GetViewProps()->GetNumberOfItems() != actors->GetNumberOfItems()) return false;
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
        if (actor->HasTranslucentPolygonalGeometry()) return false;
    return true;
}

/// Blending of what hides what is behind it changes nothing, and takes a sixth of the time that a software renderer
/// needs.
void blend(vtkObject* layer, unsigned long event, void*, void*) {
    auto* state = static_cast<vtkOpenGLRenderWindow*>(static_cast<vtkRenderer*>(layer)->GetRenderWindow())->GetState();
    if (event == vtkCommand::StartEvent) state->vtkglDisable(GL_BLEND);
    else state->vtkglEnable(GL_BLEND);
}

/// Puts renderers into the window for one picture, and the window's context back for other threads.
class Session {
public:
    explicit Session(std::span<vtkRenderer* const> layers) : layers_(layers) {
        blending_->SetCallback(blend);
        window->SetNumberOfLayers(static_cast<int>(layers.size()));
        for (std::size_t i = 0; i < layers.size(); ++i) {
            layers[i]->SetLayer(static_cast<int>(i));
            window->AddRenderer(layers[i]);
            if (!is_opaque(layers[i])) continue;
            layers[i]->AddObserver(vtkCommand::StartEvent, blending_);
            layers[i]->AddObserver(vtkCommand::EndEvent, blending_);
        }
    }
    ~Session() {
        for (vtkRenderer* layer : layers_) window->RemoveRenderer(layer);
        window->ReleaseCurrent();
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

private:
    std::span<vtkRenderer* const> layers_;
    vtkNew<vtkCallbackCommand> blending_;
};

}  // namespace

void check_size(int width, int height) {
    if (width < smallest || width > largest || height < smallest || height > largest)
        throw InputError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels: each side must be from " + std::to_string(smallest) + " to " +
                         std::to_string(largest));
}

Pixels take_pixels(int width, int height, std::span<vtkRenderer* const> layers) {
    check_size(width, height);
    const CalmX calm;
    ready_window(width, height);
    const vtkNew<vtkUnsignedCharArray> pixels;
    {
        const Session session(layers);
        window->Render();
        window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0);
    }
    const std::string complaint = take_vtk_complaint();
    if (!display_alive()) throw OutsideError("the display was lost while a picture was drawn; draw it again");
    if (!complaint.empty()) throw OutsideError("cannot draw the picture: " + complaint);
    if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height)
        throw OutsideError("cannot draw the picture: the display gave no pixels");
    const unsigned char* first = pixels->GetPointer(0);
    return {width, height, {first, first + 3 * std::size_t(width) * height}};
}

}  // namespace hinge::output
