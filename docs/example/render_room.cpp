// Renders a scene with the pencil library: render_room SCENE.xml IMAGE.exr
#include <pencil/cl/device.h>
#include <pencil/image/write_image.h>
#include <pencil/render/render_session.h>
#include <pencil/scene/formats/load_scene.h>
#include <pencil/util/error.h>

#include <iostream>

int main(int argc, char** argv) try {
    if (argc != 3) return 2;
    const pencil::Scene scene = pencil::load_scene(argv[1]);

    pencil::RenderOptions options;  // the program's defaults
    options.width = options.height = 64;
    options.target_error = 0.01;

    pencil::RenderSession session(scene, options, pencil::Device::open(""));
    while (session.advance()) std::cout << "estimated relMSE " << session.estimated_error() << "\n";

    const pencil::RenderResult result = session.finish();
    pencil::LayeredImage image{result.width, result.height, {}};
    for (const pencil::Layer& layer : result.layers) image.layers.push_back({layer.name, layer.channels, layer.pixels.data()});
    pencil::write_image(argv[2], image);
} catch (const pencil::Error& error) {
    std::cerr << error.what() << "\n";
    return static_cast<int>(error.code());
}
