#pragma once
/// The program's event loop.

#include <QApplication>
#include <QThreadPool>
#include <iostream>

#include "render/base/thrown.h"
#include "ui/window/main_window.h"

namespace pdr::app {

/// The application. An exception thrown by an event's handler becomes a message, and the window stays open.
class Application : public QApplication {
  public:
    Application(int& argc, char** argv) : QApplication(argc, argv) {
        // Qt paints on this pool's threads and would wait forever for one that the system refuses later: start one now
        // and keep it.
        QThreadPool& pool = *QThreadPool::globalInstance();
        pool.setMaxThreadCount(1);
        pool.setExpiryTimeout(-1);
        pool.start([] {});
    }

    bool notify(QObject* receiver, QEvent* event) override {
        try {
            return QApplication::notify(receiver, event);
        } catch (...) {
            say(thrownError());
            return false;
        }
    }

  private:
    static void say(const Error& error) {
        std::cerr << "pdrender: " << error.text() << '\n';
        for (QWidget* widget : topLevelWidgets())
            if (auto* window = qobject_cast<ui::MainWindow*>(widget))
                window->message().showError(error);
    }
};

}  // namespace pdr::app
