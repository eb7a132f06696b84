// The window of the workbench for tests: offscreen, with a session folder of its own and without a look at
// what is plugged into the computer that tests.
#pragma once

#include "app/gui/app_context.h"
#include "app/gui/event_log.h"
#include "app/gui/main_window.h"
#include "app/gui/pages/plan_page.h"
#include "app/gui/pages/source_page.h"
#include "app/gui/workbench.h"
#include "app/language/language.h"
#include "widgets/style/theme.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <memory>

namespace driftbench::test {

struct GuiWindow
{
    QTemporaryDir temporary;
    Theme theme;
    EventLog events;
    Navigator navigator;
    Language language;
    std::unique_ptr<Workbench> bench;
    AppContext context{theme, events, navigator};

    explicit GuiWindow(const Settings &settings = {}, HidAccess devices = noDevices(), bool watch = true)
    {
        auto made = Workbench::create({folder(), std::move(devices), watch}, settings);
        if (!made)
            qFatal("%s", made.error().message.c_str());
        bench = *std::move(made);
        context.workbench = bench.get();
        language.set(settings.language.isEmpty() ? QStringLiteral("en") : settings.language);
        if (settings.theme == ThemeChoice::Dark)
            theme.setMode(ThemeMode::Dark);
        m_main = std::make_unique<MainWindow>(context, language);
        m_main->show();
        if (!QTest::qWaitForWindowExposed(m_main.get()))
            qFatal("the window is not shown");
    }

    MainWindow &main() { return *m_main; }
    std::filesystem::path folder() const { return temporary.path().toStdString(); }

    static HidAccess noDevices()
    {
        HidAccess access;
        access.list = [] { return std::vector<HidIdentity>(); };
        access.open = [](const HidIdentity &) -> Result<std::unique_ptr<HidTransport>> {
            return Error{Errc::DeviceNotFound, "There is no device."};
        };
        access.sysfs = "/nonexistent";
        return access;
    }

private:
    std::unique_ptr<MainWindow> m_main; // first to go
};

} // namespace driftbench::test
