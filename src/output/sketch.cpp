// Two-dimensional drawing over a whole picture, on VTK's canvas.
#include "output/sketch.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkTransform2D.h>

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace hinge::output {
namespace {

class CanvasPen : public Pen {
public:
    explicit CanvasPen(vtkContext2D& context) : context_(context) {}

    void text(double x, double y, const std::string& words, const TextStyle& style) override;
    std::array<double, 2> size_of(const std::string& words, const TextStyle& style) override;
    void path(const std::vector<Pixel>& points, double width, Colour colour) override;
    void box(double x, double y, double width, double height, Colour colour, double opacity) override;
    void dot(double x, double y, double radius, Colour colour) override;

private:
    vtkContext2D& context_;
    double drawn_size_ = 0;  ///< of what size_of was asked for last
};

class SketchItem : public vtkContextItem {
public:
    static SketchItem* New();
    vtkTypeMacro(SketchItem, vtkContextItem)

        std::function<void(Pen&)> draw;

    bool Paint(vtkContext2D* context) override {
        // VTK maps 0.5 and width - 0.5 to the picture's edges; undone here, whole numbers fall on edges of pixels.
        const double wide = GetScene()->GetSceneWidth(), high = GetScene()->GetSceneHeight();
        const vtkNew<vtkTransform2D> to_pixels;
        to_pixels->Translate(0.5, 0.5);
        to_pixels->Scale((wide - 1) / wide, (high - 1) / high);
        context->PushMatrix();
        context->AppendTransform(to_pixels);
        CanvasPen pen(*context);
        draw(pen);
        context->PopMatrix();
        return true;
    }
};
vtkStandardNewMacro(SketchItem);

void use_pen(vtkContext2D& context, Colour colour, double width) {
    vtkPen* pen = context.GetPen();
    pen->SetLineType(vtkPen::SOLID_LINE);
    pen->SetColor(colour[0], colour[1], colour[2]);
    pen->SetOpacityF(1);
    pen->SetWidth(static_cast<float>(width));
}

void use_brush(vtkContext2D& context, Colour colour, double opacity) {
    context.GetPen()->SetLineType(vtkPen::NO_PEN);
    context.GetBrush()->SetColor(colour[0], colour[1], colour[2]);
    context.GetBrush()->SetOpacityF(opacity);
}

/// DejaVu has the Greek letters and signs that VTK's built-in font lacks; fontconfig brings it along. Empty: not there.
const std::string& font_file(bool bold) {
    static const auto find = [](const std::string& name) -> std::string {
        for (const char* folder : {"truetype/dejavu", "dejavu-sans-fonts", "dejavu", "TTF"}) {
            std::string path = std::string("/usr/share/fonts/") + folder + "/" + name;
            if (::access(path.c_str(), R_OK) == 0) return path;
        }
        return {};
    };
    static const std::string plain = find("DejaVuSans.ttf"), strong = find("DejaVuSans-Bold.ttf");
    return bold ? strong : plain;
}

void use_text(vtkContext2D& context, const TextStyle& style) {
    vtkTextProperty* property = context.GetTextProp();
    const std::string& file = font_file(style.bold);
    // The italic is used for single Latin letters only: the built-in one does, and is always there.
    if (style.italic || file.empty()) {
        property->SetFontFamilyToArial();
    } else {
        property->SetFontFamily(VTK_FONT_FILE);
        property->SetFontFile(file.c_str());
    }
    property->SetFontSize(static_cast<int>(std::lround(style.size)));
    property->SetBold(style.bold);
    property->SetItalic(style.italic);
    property->SetColor(style.colour[0] / 255.0, style.colour[1] / 255.0, style.colour[2] / 255.0);
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToBottom();
}

// Placed here, not by VTK: off whole pixels its text is blurred, and its lowest row shows again above the highest.
void CanvasPen::text(double x, double y, const std::string& words, const TextStyle& style) {
    if (words.empty()) return;
    const auto [wide, high] = size_of(words, style);
    const double left = x - style.across * wide, foot = y - style.upright * high;
    TextStyle drawn = style;
    drawn.size = drawn_size_;
    use_text(context_, drawn);
    context_.DrawString(static_cast<float>(std::round(left)), static_cast<float>(std::round(foot)), words.c_str());
}

// VTK draws words as a texture that repeats. Where it needs no padding, as it is a power of two wide or high, its last
// row shows again beside the first one; a size larger by a pixel has padding.
std::array<double, 2> CanvasPen::size_of(const std::string& words, const TextStyle& style) {
    if (words.empty()) return {0, 0};
    TextStyle level = style;
    float bounds[4] = {};
    double size = style.size;
    for (int more = 0; more < 3; ++more) {
        level.size = size = style.size + more;
        use_text(context_, level);
        context_.ComputeStringBounds(words.c_str(), bounds);
        const auto repeats = [](float side) { return std::has_single_bit(static_cast<unsigned>(std::lround(side))); };
        if (!repeats(bounds[2]) && !repeats(bounds[3])) break;
    }
    drawn_size_ = size;
    return {bounds[2], bounds[3]};
}

void CanvasPen::path(const std::vector<Pixel>& points, double width, Colour colour) {
    if (points.size() < 2) return;
    use_pen(context_, colour, width);
    // DrawPoly only reads.
    context_.DrawPoly(const_cast<float*>(points.front().data()), static_cast<int>(points.size()));
}

void CanvasPen::box(double x, double y, double width, double height, Colour colour, double opacity) {
    use_brush(context_, colour, opacity);
    const auto left = static_cast<float>(std::round(x)), foot = static_cast<float>(std::round(y));
    const auto right = static_cast<float>(std::round(x + width)), top = static_cast<float>(std::round(y + height));
    context_.DrawRect(left, foot, right - left, top - foot);
}

void CanvasPen::dot(double x, double y, double radius, Colour colour) {
    use_brush(context_, colour, 1);
    context_.DrawEllipse(static_cast<float>(x), static_cast<float>(y), static_cast<float>(radius),
                         static_cast<float>(radius));
}

}  // namespace

void Pen::line(double x0, double y0, double x1, double y1, double width, Colour colour) {
    const double thick = std::max(1.0, std::round(width));
    if (x0 == x1) return box(x0 - thick / 2, std::min(y0, y1), thick, std::abs(y1 - y0), colour);
    if (y0 == y1) return box(std::min(x0, x1), y0 - thick / 2, std::abs(x1 - x0), thick, colour);
    path({{static_cast<float>(x0), static_cast<float>(y0)}, {static_cast<float>(x1), static_cast<float>(y1)}}, width,
         colour);
}

vtkSmartPointer<vtkRenderer> sketch(std::function<void(Pen&)> draw) {
    const vtkNew<SketchItem> item;
    item->draw = std::move(draw);
    const vtkNew<vtkContextActor> actor;
    actor->GetScene()->AddItem(item);
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetBackground(1, 1, 1);
    renderer->AddActor(actor);
    return renderer;
}

}  // namespace hinge::output
