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
        QString room;     ///< files whose path begins so ...
        QString include;  ///< ... may include our own headers, or foreign ones, only where this matches
    };

    /// The rooms of the window's panels: none knows another.
    inline static const QStringList kPanels{"accuracy", "camera",  "cut",   "keys",   "light", "looks",
                                            "manual",   "measure", "nodes", "output", "parts", "rendering",
                                            "series",   "slices",  "theme", "tissue"};

    /// Our own rooms: the longest matching entry counts.
    static QList<Wall> rooms() {
        const QString below = "|^render/(base|volume|slice|scene|film|accuracy|timing)/|^dicom/series.h";
        QList<Wall> all{
            {"render/base/", "^render/base/"},
            {"render/volume/", "^render/(base|volume)/"},
            {"render/kernel/", "^render/(base|kernel/[^/]*$)"},
            {"render/kernel/walk/", "^render/(base|kernel/([^/]*$|walk))"},
            {"render/kernel/transport/", "^render/(base|kernel/([^/]*$|bounds|walk|transport))"},
            {"render/kernel/quadrature/", "^render/(base|kernel/([^/]*$|bounds|walk|transport|quadrature))"},
            {"render/kernel/bounds/", "^render/(base|kernel/([^/]*$|bounds))"},
            {"render/kernel/baseline/", "^render/(base|kernel/([^/]*$|bounds|transport|baseline))"},
            {"render/slice/", "^render/(base/|volume/|slice/|kernel/[^/]*$)"},
            {"render/film/", "^render/(base/|denoise/|film/[^/]*$)"},
            {"render/film/error/", "^render/(base/|denoise/|film/([^/]*$|error/))"},
            {"render/film/display/", "^render/(base/|denoise/|film/([^/]*$|error/|display/))"},
            {"render/film/file/", "^render/(base|denoise|film)/"},
            {"render/denoise/", "^render/(base|denoise)/"},
            {"render/edit/", "^render/(base|denoise|edit|film)/"},
            {"render/accuracy/", "^render/(base|film|scene|accuracy)/"},
            {"render/timing/", "^render/(base|accuracy|timing)/"},
            {"render/segment/", "^render/(base|volume|segment)/"},
            {"render/smooth/", "^render/(base|volume|smooth)/"},
            {"render/measure/", "^render/(base/|volume/|kernel/[^/]*$|measure/)"},
            {"render/scene/", "^render/(base/|volume/|segment/|scene/([^/]*$|fields/)|film/display.h)"},
            {"render/scene/edit/", "^render/(base/|volume/|segment/|scene/([^/]*$|edit/))"},
            {"render/scene/slicer/", "^render/(base|volume|segment|scene)/"},
            {"render/prepare/", "^render/(base|volume|kernel|scene|prepare)/"},
            {"render/device/", "^render/(base|kernel|film|prepare|device)/|^render/scene/(scene|schedule).h"},
            {"render/session/",
             "^render/(base|volume|kernel|edit|film|scene|prepare|device|accuracy|timing|session|smooth)/"},
            {"render/tiles/", "^render/(base|volume|film|device|timing|tiles)/|^render/scene/(scene|schedule).h"},
            {"dicom/", "^dicom/[^/]*$|^render/(base|volume)/|^render/slice/grey_window.h$"},
            {"dicom/read/", "^dicom/([^/]*$|read/)|^render/base/"},
            {"dicom/segmentation/", "^dicom/([^/]*$|read/|segmentation/)|^render/(base|volume)/"},
            {"dicom/source/", "^dicom/([^/]*$|source/)|^render/base/"},
            {"dicom/stack/", "^dicom/([^/]*$|read/|stack/)|^render/(base|volume)/"},
            {"dicom/write/", "^dicom/([^/]*$|read/|write/)|^render/(base|volume)/"},
            {"ui/text/", "^ui/text/" + below},
            {"ui/annotation/", "^ui/(annotation|text)/" + below},
            {"ui/widgets/", "^ui/(widgets|text)/" + below},
            {"ui/view/", "^ui/(view|annotation|widgets|text)/" + below},
            {"ui/window/", "^ui/(window|accuracy/accuracy_status.h|keys|theme|view|annotation|widgets|text)/?" + below},
            {"app/program/", "^app/program/"},
            {"app/command_line/", "^app/command_line/|^render/(base|scene)/"},
            {"app/selftest/", "^app/selftest/|^render/"},
            {"app/bench/", "^app/(bench|program|selftest)/|^render/"},
            {"app/remote/", "^app/(remote|wire)/|^render/base/"},
            {"app/wire/", "^app/wire/|^render/(base/|film/moments.h$)"},
            {"app/coordinator/", "^app/(coordinator|remote|wire)/|^render/(base|film|scene|tiles|volume)/"},
            {"app/node/", "^app/(node|coordinator|remote|wire|program|command_line)/|^render/(base|device|tiles)/"},
            {"app/plan/", "^app/(plan/|wire/content_hash.h$)|^render/(base|scene|volume|segment|slice|measure)/"},
            {"app/scan/", "^app/(scan/|wire/one_frame.h)|^(dicom|render)/"},
            {"app/looks/", "^app/looks/|^render/"},
            {"app/output/", "^app/output/|^ui/(annotation|text)/|^render/"},
            {"app/jobs/", "^app/(jobs|scan|looks|output|plan)/|^ui/(annotation|text)/|^(dicom|render)/"},
            {"app/document/", "^app/(document|plan|scan|looks)/|^render/"},
            {"app/cli/",
             "^app/((cli|command_line|program|plan|scan|looks|output|coordinator|remote)/|wire/content_hash.h$)"
             "|^ui/(annotation|text)/|^(dicom|render)/"},
            {"app/rendering/", "^app/(rendering|output)/|^ui/(annotation|text)/|^render/"},
            {"app/presenters/",
             "^app/(presenters|rendering|document|plan|jobs|scan|looks|output|coordinator|remote)/"
             "|^(ui|dicom|render)/"},
            {"app/desktop/",
             "^app/(desktop|presenters|rendering|looks|program|command_line)/|^ui/(window|text|theme)/|^render/"},
            {"tests/ptx/", "^tests/(ptx|support)/|^render/|^app/node/"},
            {"tests/ptx/base/", "^tests/ptx/base/"},
            {"tests/ptx/text/", "^tests/ptx/(base|text)/"},
            {"tests/ptx/code/", "^tests/ptx/(base/|text/|code/|operations/operations.h$)"},
            {"tests/ptx/machine/", "^tests/ptx/(base/|text/|code/program.h$|machine/)"},
            {"tests/ptx/operations/", "^tests/ptx/(base/|text/|code/instruction.h$|machine/|operations/)"},
            {"tests/ptx/runtime/", "^tests/ptx/(base/|text/|code/decode.h$|machine/|runtime/)"},
            {"tests/ptx/checks/", "^tests/(ptx|support)/|^render/"},
        };
        for (const QString& panel : kPanels)
            all << Wall{"ui/" + panel + "/", "^ui/(" + panel + "|view|annotation|widgets|text)/" + below};
        return all;
    }

    static QStringList files() {
        QStringList found;
        for (const char* room : {"render", "dicom", "ui", "app", "tests/ptx"}) {
            QDirIterator walk(QStringLiteral(PDR_SOURCE_DIR "/") + room, {"*.h", "*.cpp", "*.cu", "*.cuh"}, QDir::Files,
                              QDirIterator::Subdirectories);
            while (walk.hasNext())
                found << QDir(PDR_SOURCE_DIR).relativeFilePath(walk.next());
        }
        return found;
    }

    static bool crosses(const QString& file, const QString& include) {
        static const QRegularExpression ours("^(render|dicom|ui|app|tests/ptx)/");
        const auto matches = [](const QString& pattern, const QString& text) {
            return QRegularExpression(pattern).match(text).hasMatch();
        };
        if (ours.match(include).hasMatch() || (file.startsWith("tests/ptx/") && include.startsWith("tests/"))) {
            static const QList<Wall> walls = rooms();
            const Wall* room = nullptr;
            for (const Wall& wall : walls)
                if (file.startsWith(wall.room) && (!room || wall.room.size() > room->room.size()))
                    room = &wall;
            return !room || !matches(room->include, include);
        }
        if (matches("^(tests|tools)/", include))
            return true;
        if (matches("^(Q[A-Z]|Qt|q[a-z]+\\.h$)", include))
            return matches("^(render|dicom|app/(bench|plan|selftest))/", file);
        if (matches("^(dcmtk|dcm)", include))
            return !matches("^dicom/.*\\.cpp$", file);
        if (matches("^(Imf|Imath|OpenEXR|png)", include))
            return !matches("^render/film/file/(image_file.cpp|pixel_file.cpp|png_encoder.cpp|exr_stream.h)$", file);
        if (matches("^nlohmann/", include))
            return !matches("^(render/scene/(json_fields|field_writer|slicer/vp_json)\\.|app/)", file);
        if (matches("^zstd", include))
            return file != "app/wire/one_frame.cpp" && file != "tests/ptx/text/fat_binary.cpp";
        if (include == "zip.h")
            return file != "dicom/source/zip_handle.cpp";
        if (matches("^openssl/", include))
            return !matches("^app/(wire|remote)/.*\\.cpp$", file);
        if (matches("^cuda", include))
            return !matches("^(render/device/cuda/|render/base/portable.h|tests/ptx/(runtime|checks)/)", file);
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
                                    "png.h", "nlohmann/json.hpp", "cuda_runtime.h", "tools/measure/stated_figures.h"})
            QCOMPARE(crossings("render/film/film.cpp", QStringLiteral("\n#include <%1>\n").arg(include)).size(), 1);
        QCOMPARE(crossings("render/film/film.cpp", "#include <vector>\n#include \"render/base/result.h\"").size(), 0);
        QCOMPARE(crossings("ui/view/viewport.cpp", "#include <QWidget>\n#include \"dicom/import.h\""),
                 QStringList{"ui/view/viewport.cpp includes dicom/import.h"});
        QCOMPARE(crossings("ui/light/light_panel.cpp", "#include \"ui/tissue/points_plot.h\"").size(), 1);
        QCOMPARE(crossings("app/plan/history.h", "#include <QString>").size(), 1);
        QCOMPARE(crossings("ui/window/main_window.h", "#include \"ui/tissue/tissue_panel.h\"").size(), 1);
        QCOMPARE(crossings("app/presenters/presenter.h", "#include \"app/desktop/desktop.h\"").size(), 1);
        QCOMPARE(crossings("tests/ptx/text/module.h", "#include \"tests/ptx/runtime/runtime.h\"").size(), 1);
        QCOMPARE(crossings("tests/ptx/machine/warp.h", "#include \"tests/support/places.h\"").size(), 1);
    }

    /// A newcomer looks for a room first: no source file lies outside of one.
    void noSourceLiesInTheHall() {
        const auto isFlat = [](const QString& file) {
            return (file.startsWith("app/") || file.startsWith("ui/")) && file.count(u'/') == 1;
        };
        const QStringList all = files();
        for (const QString& file : all)
            QVERIFY2(!isFlat(file), qPrintable(file));
    }
};

QTEST_APPLESS_MAIN(WallsTest)
#include "walls_test.moc"
