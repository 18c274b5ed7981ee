// `pencil walk`: a field of pencils from one camera after the other. What does not depend on the camera is made once.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/outputs.h"
#include "app/views.h"
#include "cl/build_ahead.h"
#include "field/field_file.h"
#include "render/render_session.h"
#include "scene/formats/load_scene.h"
#include "util/log.h"
#include "util/stopwatch.h"

namespace pencil {
namespace {

std::filesystem::path numbered(const std::filesystem::path& output, std::size_t number) {
    std::filesystem::path name = output;
    return name.replace_filename(fmt::format("{}-{:04}{}", output.stem().string(), number, output.extension().string()));
}

void write_view(const RenderSession& session, const std::filesystem::path& file) {
    const std::vector<Layer> layers = session.snapshot();
    const LayeredImage image{session.options().width, session.options().height, {{"", 3, layers.front().pixels.data()}}};
    write_images({file}, image, {}, false);
}

void check_images(const WalkCommand& command, std::size_t views) {
    for (std::size_t k = 1; k <= views; ++k)
        for (const std::filesystem::path& read : {command.field, command.views, command.scene})
            if (const std::filesystem::path image = numbered(command.output, k); same_file(image, read))
                throw OutputError("cannot write " + image.string() + ": it is read");
}

/// Seconds of the views that are written, without writing them; the first brings what all need.
std::vector<double> show(RenderSession& session, const std::vector<PerspectiveSensor>& views, const std::filesystem::path& output) {
    std::vector<double> seconds;
    for (std::size_t k = 0; k < views.size() && interrupted_by() == 0; ++k) {
        const Stopwatch watch;
        if (k == 0)
            while (session.advance()) {
            }
        else
            session.look(views[k]);
        const double taken = watch.seconds();
        if (session.interrupted()) break;
        write_view(session, numbered(output, k + 1));
        seconds.push_back(taken);
    }
    return seconds;
}

}  // namespace

ExitCode run_walk(const WalkCommand& command) {
    set_quiet(command.quiet);
    allow_build_ahead("/proc/self/exe");
    check_outputs({numbered(command.output, 1)}, {}, command.scene);
    Scene scene = load_scene(command.scene, command.load);
    for (const std::string& warning : scene.warnings) print_warning(warning);
    const std::vector<PerspectiveSensor> views = read_views(command.views, scene.sensor);
    check_images(command, views.size());
    scene.sensor = views.front();
    RenderOptions options = command.options;
    open_field(command.field, options);
    options.method = command.method == WalkMethod::line ? MethodName::line : MethodName::hybrid;
    options.thin = !command.every_pixel;
    RenderSession session(scene, options, Device::open(command.device), [](const std::string&, double) { return interrupted_by() == 0; });
    std::vector<double> seconds = show(session, views, command.output);
    for (const std::string& warning : session.stats().warnings) print_warning(warning);
    if (interrupted_by() != 0) {
        print_error(fmt::format("interrupted; {} of {} views are written", seconds.size(), views.size()));
        return ExitCode::interrupted;
    }
    if (command.quiet) return ExitCode::ok;
    std::cout << fmt::format("wrote {} views, {} to {}; the first took {:.2f} s", views.size(), numbered(command.output, 1).string(),
                             numbered(command.output, views.size()).string(), seconds.front());
    std::sort(seconds.begin() + 1, seconds.end());
    if (seconds.size() > 1) std::cout << fmt::format(", the others {:.3f} s each, in the median", seconds[1 + (seconds.size() - 1) / 2]);
    if (shows_part(options)) std::cout << fmt::format("; {} of {} pencils were read", session.stats().field_read, options.field->count());
    std::cout << '\n';
    return ExitCode::ok;
}

}  // namespace pencil
