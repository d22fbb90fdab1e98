/// Measures how soon the small images of the looks are there, beside a session that renders at full load.
///   gallery FOLDER
/// FOLDER holds a CT. Prints the seconds from the first scene of the volume to each image, and the processor
/// time of the whole program until the last.

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <cstdio>
#include <ctime>

#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "app/presenters/looks_presenter.h"

int main(int argc, char** argv) {
    using namespace pdr::app;
    QApplication application(argc, argv);
    const QString folder = QCoreApplication::arguments().value(1);
    const auto looks = bundledLooks();
    if (folder.isEmpty() || !looks)
        return 2;
    const QTemporaryDir settings;
    Desktop desktop(*looks, pdr::makeCpuDevice(), settings.filePath("settings.ini"));
    QElapsedTimer clock;
    QObject::connect(&desktop.document(), &Document::sceneChanged, &application, [&] {
        if (!clock.isValid())
            clock.start();
    });
    std::size_t made = 0;
    QObject::connect(&desktop.presenter<LooksPresenter>().images(), &LookImages::made, &application, [&](int look) {
        std::printf("%5.2f s  %s\n", double(clock.elapsed()) / 1000, (*looks)[std::size_t(look)].name.c_str());
        if (++made == looks->size()) {
            std::printf("%5.2f s of the processor\n", double(std::clock()) / CLOCKS_PER_SEC);
            QCoreApplication::quit();
        }
    });
    desktop.window().resize(1100, 800);
    desktop.window().show();
    desktop.open(folder);
    return QApplication::exec();
}
