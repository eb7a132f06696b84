// The page Record: live traces of the run that is being recorded, and its read-outs. The view may be paused;
// recording goes on. Whatever the device does is said in the banner, and nothing that was taken is lost.
#pragma once

#include "app/gui/banner_of.h"
#include "app/gui/page.h"
#include "app/session/job.h"
#include "engine/base/result.h"
#include "engine/recording/recording.h"

#include <QTimer>

#include <memory>
#include <optional>

class QStackedWidget;

namespace driftbench {

class EmptyState;
class LegendRow;
class LiveRun;
class LiveTraceView;
class RecordReadouts;
class SegmentedButtons;
struct RecorderEvent;

class RecordPage : public Page
{
    Q_OBJECT

public:
    explicit RecordPage(AppContext &context, QWidget *parent = nullptr);

    StepState stepState() const override;
    QString hints() const override;
    void entered() override;

    LiveTraceView &view() const { return *m_view; }
    LiveRun &run() const { return *m_run; }
    RecordReadouts &readouts() const { return *m_readouts; }

public slots:
    void startRecording();
    void stopRecording();
    void setViewPaused(bool paused);

protected:
    void retranslate() override;
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QWidget *makeBody();
    QWidget *makeTraces();
    void addActions();
    void connectWork();
    void endRun();
    void sourceStarted();
    void sourceEnded(const Error &error);
    void recordingFinished(const Status &outcome);
    void recorderSays(const RecorderEvent &event);
    void showState(); // buttons, head, empty state
    void showContext();
    void showFigures(); // four times a second
    void showPauseBanner();
    void showAbsence();
    void showLegend();
    void say(const QString &key, BannerKind kind, Words what, Words toDo, std::vector<QAction *> actions = {},
             bool closable = true);
    void saveUnwritten();
    void writeRest(const QString &file);
    void restWritten(const Status &outcome);
    int runNumber() const;
    int runsWanted() const;

    LiveTraceView *m_view;
    LiveRun *m_run;
    RecordReadouts *m_readouts;
    LegendRow *m_legend;
    SegmentedButtons *m_span;
    SegmentedButtons *m_quantity;
    QStackedWidget *m_panelStack;
    EmptyState *m_empty;
    ActionButton *m_pauseButton;
    ActionButton *m_stopButton;
    ActionButton *m_startButton;
    QAction *m_start;
    QAction *m_stop;
    QAction *m_pause;
    QAction *m_goToSource;
    QAction *m_goToInspect;
    QAction *m_writeAgain;
    QAction *m_saveRest;
    QTimer m_figures;
    bool m_starting = false;  // the source is being opened for a run
    bool m_brokenOff = false; // the run ends before its plan: by the user, or by an error
    std::optional<int> m_percent;
    std::shared_ptr<const Recording> m_rest; // of a run, that no file has yet
    QString m_restFile;
    TaskJob m_savingRest;
};

} // namespace driftbench
