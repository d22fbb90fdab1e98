#pragma once
/// A ball with a radius of 12 voxels in air, as a raw file, and a scene file that shows it, in a temporary folder.

#include <QFile>
#include <QTemporaryDir>

#include "tests/support/program_run.h"

namespace pdr::test {

class BallScene {
  public:
    BallScene() {
        QByteArray voxels;
        for (int z = 0; z < 32; ++z)
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 32; ++x) {
                    const int r2 = (x - 16) * (x - 16) + (y - 16) * (y - 16) + (z - 16) * (z - 16);
                    const qint16 hu = r2 < 144 ? 1000 : -1000;
                    voxels.append(reinterpret_cast<const char*>(&hu), 2);
                }
        write(at("ball.raw"), voxels);
        write(scene(), R"({ "format": "pdrender-scene", "version": 1,
            "volume": { "raw": "ball.raw", "size": [32, 32, 32], "spacingMm": [1, 1, 1] },
            "transferFunction": { "extinctionPerMm": 0.5, "nodes": [ { "hu": 0, "opacity": 0 }, { "hu": 500, "opacity": 1 } ] },
            "lights": [ { "type": "directional", "direction": [1, 1, -1], "irradiance": 3 },
                        { "type": "environment", "radiance": 0.2, "visible": false } ],
            "camera": { "eyeMm": [16, -80, 16], "targetMm": [16, 16, 16], "fovDegrees": 25 },
            "film": { "width": 48, "height": 40 } })");
    }

    QString path() const { return folder_.path(); }
    QString at(const QString& name) const { return folder_.filePath(name); }
    QString scene() const { return at("scene.json"); }

    static QByteArray contents(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static void write(const QString& path, const QByteArray& bytes) {
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("the test cannot write its files");
    }

    /// Runs pdrender-cli.
    static ProgramRun run(const QStringList& arguments) { return runProgram("pdrender-cli", arguments); }

  private:
    QTemporaryDir folder_;
};

}  // namespace pdr::test
