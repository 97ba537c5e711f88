// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "sightline/viz/render.hpp"
#include "viz/scene_vtk.hpp"
#include "viz/x_display.hpp"

namespace sightline::viz {
namespace {

constexpr unsigned largest_side = 8000;
constexpr unsigned largest_window_side = 16000;  // what software OpenGL offers is 16384

/// A connection to the user's display when it works, or else to a server of our own.
struct Display {
    std::optional<detail::Xvfb> server;
    std::optional<detail::XConnection> connection;

    Display() = default;
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    ~Display() {
        connection.reset();
        server.reset();
    }

    [[nodiscard]] Result<void> open() {
        if (auto own = detail::XConnection::open("")) {
            connection.emplace(std::move(*own));
            return {};
        }
        auto started = detail::Xvfb::start();
        if (!started) return tl::unexpected(started.error());
        server.emplace(std::move(*started));
        auto opened = detail::XConnection::open(server->name());
        if (!opened) return tl::unexpected(opened.error());
        connection.emplace(std::move(*opened));
        return {};
    }
};

/// The picture in red, green and blue bytes, the lowest row first.
struct Pixels {
    unsigned width = 0;
    unsigned height = 0;
    vtkNew<vtkUnsignedCharArray> bytes;
};

void draw_pixels(const DrawList& list, const detail::Layout& layout, unsigned scale, void* display,
                 Pixels& result) {
    const detail::VtkPage page(list, layout, scale, false);
    result.width = static_cast<unsigned>(layout.width) * scale;
    result.height = static_cast<unsigned>(layout.height) * scale;
    vtkNew<vtkRenderWindow> window;
    window->SetDisplayId(display);
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetAlphaBitPlanes(1);
    window->SetSize(static_cast<int>(result.width), static_cast<int>(result.height));
    window->AddRenderer(page.page());
    window->AddRenderer(page.drawing());
    window->Render();
    window->GetPixelData(0, 0, static_cast<int>(result.width) - 1,
                         static_cast<int>(result.height) - 1, 0, result.bytes);
}

/// The mean of squares of scale × scale pixels.
vtkSmartPointer<vtkImageData> reduced(const Pixels& pixels, unsigned scale) {
    const unsigned width = pixels.width / scale;
    const unsigned height = pixels.height / scale;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
    const unsigned char* in = pixels.bytes->GetPointer(0);
    const unsigned area = scale * scale;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                unsigned sum = area / 2;
                for (std::size_t k = 0; k < area; ++k) {
                    const std::size_t row = y * scale + k / scale;
                    sum += in[3 * (row * pixels.width + x * scale + k % scale) + channel];
                }
                *out++ = static_cast<unsigned char>(sum / area);
            }
        }
    }
    return image;
}

Result<void> write_file(const std::string& path, const unsigned char* data, std::size_t size) {
    static std::atomic<unsigned> counter{0};
    const std::string temporary = fmt::format("{}.{}-{}.tmp", path, ::getpid(), counter++);
    const auto failed = [&] {
        const std::string why = std::strerror(errno);
        ::unlink(temporary.c_str());
        return fail(Errc::cannot_write,
                    fmt::format("{}: cannot write: {}; check folder, rights and space", path, why));
    };
    std::FILE* file = std::fopen(temporary.c_str(), "wbx");
    if (file == nullptr) return failed();
    const bool written = std::fwrite(data, 1, size, file) == size;
    if ((std::fclose(file) != 0 || !written) || std::rename(temporary.c_str(), path.c_str()) != 0) {
        return failed();
    }
    return {};
}

}  // namespace

bool has_rendering() noexcept { return true; }

Result<void> render_png(const DrawList& drawn, const std::string& path,
                        const RenderOptions& options) {
    if (options.width < 100 || options.width > largest_side || options.height > largest_side ||
        (options.height != 0 && options.height < 100) || options.supersampling == 0) {
        return fail(
            Errc::bad_parameter,
            fmt::format("cannot draw a picture of {} x {} pixels; take 100 to {} for each side",
                        options.width, options.height, largest_side));
    }
    const DrawList list = projected(drawn);
    const detail::Layout layout =
        detail::make_layout(list, {.width = static_cast<double>(options.width),
                                   .height = static_cast<double>(options.height),
                                   .legend = options.legend});
    const auto longer = static_cast<unsigned>(std::max(layout.width, layout.height));
    const unsigned scale = std::clamp(largest_window_side / longer, 1U, options.supersampling);
    Display display;
    if (auto opened = display.open(); !opened) return opened;
    Pixels pixels;
    draw_pixels(list, layout, scale, display.connection->handle(), pixels);

    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(reduced(pixels, scale));
    writer->WriteToMemoryOn();
    writer->Write();
    const vtkUnsignedCharArray* png = writer->GetResult();
    if (png == nullptr)
        return fail(Errc::cannot_write, path + ": VTK could not encode the picture");
    return write_file(path, writer->GetResult()->GetPointer(0),
                      static_cast<std::size_t>(writer->GetResult()->GetNumberOfValues()));
}

}  // namespace sightline::viz
