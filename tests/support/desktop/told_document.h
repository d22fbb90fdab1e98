#pragma once
/// A document with a volume, and a record of its signals.

#include <memory>
#include <vector>

#include "app/document/document.h"

namespace pdr::app {

inline std::vector<NamedLook> twoLooks() {
    std::vector<NamedLook> looks(2);
    looks[0].name = "first";
    looks[0].look.transferFunction.nodes = {{0, 0}, {300, 1}};
    looks[0].look.display.exposure = 2;
    looks[1].name = "second";
    looks[1].look.transferFunction.nodes = {{-500, 0.5f}};
    looks[1].look.phaseG = 0.5f;
    looks[1].look.display.exposure = 8;
    return looks;
}

inline std::shared_ptr<const Volume> cube() {
    return std::make_shared<const Volume>(VolumeGeometry::aligned({4, 4, 4}, {10, 10, 10}, {-15, 85, 185}),
                                          Voxels(64, 100));
}

struct Told {
    Told() : document(twoLooks()) {
        QObject::connect(&document, &Document::sceneChanged, [this](const Scene& scene, bool moving) {
            scenes.push_back(scene);
            lastMoves = moving;
        });
        QObject::connect(&document, &Document::displayChanged,
                         [this](const Display& display) { displays.push_back(display); });
        QObject::connect(&document, &Document::changed, [this](Changes changes) { reports.push_back(changes); });
        document.setViewSize({400, 200});
        document.open(cube());
    }

    Document document;
    std::vector<Scene> scenes;
    std::vector<Display> displays;
    std::vector<Changes> reports;
    bool lastMoves = false;
};

}  // namespace pdr::app
