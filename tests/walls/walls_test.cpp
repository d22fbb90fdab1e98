#include <QtTest>

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

#include "tests/support/places.h"

/// Reads every #include of the tree and fails where one crosses a wall of the house (design in
/// resources/manual/developer.md).
class WallsTest : public QObject {
    Q_OBJECT

    struct Wall {
        const char* room;     ///< files whose path begins so ...
        const char* include;  ///< ... may include our own headers, or foreign ones, only where this matches
    };

    /// Our own rooms: the longest matching entry counts.
    inline static const QList<Wall> kOwn{
        {"render/base/", "^render/base/"},
        {"render/volume/", "^render/(base|volume)/"},
        {"render/kernel/", "^render/(base|kernel/[^/]*$)"},
        {"render/kernel/walk/", "^render/(base|kernel/([^/]*$|walk))"},
        {"render/kernel/transport/", "^render/(base|kernel/([^/]*$|bounds|walk|transport))"},
        {"render/kernel/quadrature/", "^render/(base|kernel/([^/]*$|bounds|walk|transport|quadrature))"},
        {"render/kernel/bounds/", "^render/(base|kernel/([^/]*$|bounds))"},
        {"render/kernel/baseline/", "^render/(base|kernel/([^/]*$|bounds|transport|baseline))"},
        {"render/film/", "^render/(base|denoise|film)/"},
        {"render/denoise/", "^render/(base|denoise)/"},
        {"render/accuracy/", "^render/(base|film|scene|accuracy)/"},
        {"render/timing/", "^render/(base|accuracy|timing)/"},
        {"render/segment/", "^render/(base|volume|segment)/"},
        {"render/scene/", "^render/(base|volume|segment|scene)/|^render/film/display.h"},
        {"render/prepare/", "^render/(base|volume|kernel|scene|prepare)/"},
        {"render/device/", "^render/(base|kernel|film|prepare|device)/|^render/scene/(scene|schedule).h"},
        {"render/session/", "^render/(base|volume|kernel|film|scene|prepare|device|accuracy|timing|session)/"},
        {"render/tiles/", "^render/(base|volume|film|device|timing|tiles)/|^render/scene/(scene|schedule).h"},
        {"dicom/", "^dicom/|^render/(base|volume)/"},
        {"ui/", "^ui/|^render/(base|volume|scene|film|accuracy|timing)/|^dicom/series.h"},
        {"app/program/", "^app/program/"},
        {"app/selftest/", "^app/selftest/|^render/"},
        {"app/bench/", "^app/(bench|program|selftest)/|^render/"},
        {"app/remote/", "^app/(remote|wire)/|^render/base/"},
        {"app/wire/", "^app/wire/|^render/base/"},
        {"app/coordinator/", "^app/(coordinator|remote|wire)/|^render/(base|film|scene|tiles|volume)/"},
        {"app/", "^(app|ui|dicom|render)/"},
    };

    static QStringList files() {
        QStringList found;
        for (const char* room : {"render", "dicom", "ui", "app"}) {
            QDirIterator walk(QStringLiteral(PDR_SOURCE_DIR "/") + room, {"*.h", "*.cpp", "*.cu", "*.cuh"}, QDir::Files,
                              QDirIterator::Subdirectories);
            while (walk.hasNext())
                found << QDir(PDR_SOURCE_DIR).relativeFilePath(walk.next());
        }
        return found;
    }

    static bool crosses(const QString& file, const QString& include) {
        static const QRegularExpression ours("^(render|dicom|ui|app)/");
        const auto matches = [](const char* pattern, const QString& text) {
            return QRegularExpression(pattern).match(text).hasMatch();
        };
        if (ours.match(include).hasMatch()) {
            const Wall* room = nullptr;
            for (const Wall& wall : kOwn)
                if (file.startsWith(wall.room) && (!room || qstrlen(wall.room) > qstrlen(room->room)))
                    room = &wall;
            return !room || !matches(room->include, include);
        }
        if (matches("^(Q[A-Z]|Qt|q[a-z]+\\.h$)", include))
            return matches("^(render|dicom|app/bench|app/selftest)/", file);
        if (matches("^(dcmtk|dcm)", include))
            return !matches("^dicom/.*\\.cpp$", file);
        if (matches("^(Imf|Imath|OpenEXR|png)", include))
            return file != "render/film/file/image_file.cpp";
        if (matches("^nlohmann/", include))
            return !matches("^(render/scene/(json_fields|field_writer|slicer/vp_json)\\.|app/)", file);
        if (matches("^zstd", include))
            return file != "app/wire/one_frame.cpp";
        if (matches("^openssl/", include))
            return !matches("^app/(wire|remote)/.*\\.cpp$", file);
        if (matches("^cuda", include))
            return !matches("^(render/device/cuda/|render/base/portable.h)", file);
        return false;
    }

    static QStringList crossings(const QString& file, const QString& text) {
        static const QRegularExpression directive("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]",
                                                  QRegularExpression::MultilineOption);
        QStringList found;
        for (auto each = directive.globalMatch(text); each.hasNext();) {
            const QString include = each.next().captured(1);
            if (crosses(file, include))
                found << file + " includes " + include;
        }
        return found;
    }

  private slots:
    void noIncludeCrossesAWall() {
        QStringList found;
        QVERIFY(files().size() > 30);
        for (const QString& name : files()) {
            QFile file(QStringLiteral(PDR_SOURCE_DIR "/") + name);
            QVERIFY(file.open(QIODevice::ReadOnly));
            found << crossings(name, QString::fromUtf8(file.readAll()));
        }
        QVERIFY2(found.isEmpty(), qPrintable("\n" + found.join("\n")));
    }

    void aCrossedWallIsSeen() {
        for (const char* include : {"QString", "dicom/series.h", "render/scene/scene.h", "dcmtk/config/osconfig.h",
                                    "png.h", "nlohmann/json.hpp", "cuda_runtime.h"})
            QCOMPARE(crossings("render/film/film.cpp", QStringLiteral("\n#include <%1>\n").arg(include)).size(), 1);
        QCOMPARE(crossings("render/film/film.cpp", "#include <vector>\n#include \"render/base/result.h\"").size(), 0);
        QCOMPARE(crossings("ui/view/viewport.cpp", "#include <QWidget>\n#include \"dicom/import.h\""),
                 QStringList{"ui/view/viewport.cpp includes dicom/import.h"});
    }
};

QTEST_APPLESS_MAIN(WallsTest)
#include "walls_test.moc"
