// The part of DevicePanel that shows an upload: how far it is, and how it ended.
#include "app/gui/export/device_panel.h"

#include "app/gui/export/device_words.h"
#include "app/gui/export/upload_steps.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/number_text.h"

#include <QProgressBar>

#include <algorithm>

namespace driftbench {

static UploadSteps::Step stepAt(const QString &stage, double fraction)
{
    if (stage.isEmpty())
        return UploadSteps::Begin;
    return fraction >= kUploadCommitted  ? UploadSteps::Activate
           : fraction >= kUploadVerified ? UploadSteps::Commit
           : fraction >= kUploadReadBack ? UploadSteps::Verify
           : fraction >= kUploadWritten  ? UploadSteps::ReadBack
                                         : UploadSteps::Write;
}

void DevicePanel::showProgress(const QString &stage, double fraction)
{
    if (!m_writing)
        return;
    m_fraction = fraction;
    const UploadSteps::Step step = stepAt(stage, fraction);
    if (step >= UploadSteps::Write)
        showBytes(UploadSteps::Write, fraction / kUploadWritten);
    if (step >= UploadSteps::ReadBack)
        showBytes(UploadSteps::ReadBack, (fraction - kUploadWritten) / (kUploadReadBack - kUploadWritten));
    m_steps->setState(UploadSteps::State::Running, step);
    m_bar->setValue(static_cast<int>(1000.0 * fraction));
    m_percent->setText(tr("%1 %").arg(numberText(100.0 * fraction, 0)));
    m_title->setText(step == UploadSteps::Activate ? tr("Activating and checking")
                                                   : tr("Writing the spare bank"));
    m_note->setText(tr("The table in use stays active until the last step."));
    m_cancelButton->show();
    emit stateChanged();
}

void DevicePanel::showBytes(int step, double share)
{
    const double bytes = m_preview ? static_cast<double>(m_preview->image.size()) : 0.0;
    m_steps->setDetail(
        static_cast<UploadSteps::Step>(step),
        tr("%1 of %2 B").arg(numberText(std::min(1.0, share) * bytes, 0), numberText(bytes, 0)));
}

void DevicePanel::showUploadIdle()
{
    m_fraction = 0.0;
    m_showOutcome = {};
    m_steps->setState(UploadSteps::State::Idle);
    for (int step = 0; step < UploadSteps::kSteps; ++step)
        m_steps->setDetail(static_cast<UploadSteps::Step>(step), {});
    m_bar->setValue(0);
    m_percent->setText({});
    m_title->setText(tr("Write to the device"));
    m_note->setText(tr("The table in use stays active until the last step."));
    m_cancelButton->hide();
}

void DevicePanel::showWord(const QString &text, int tone)
{
    m_result->setTone(static_cast<Tone>(tone));
    m_result->setText(text);
    m_result->setVisible(!text.isEmpty());
}

// At the step where it ended. Until the last one the device has not changed what it uses.
void DevicePanel::showFailed(const Error &error)
{
    const bool cancelled = error.code == Errc::Cancelled;
    const bool unsure = !cancelled && m_steps->current() == UploadSteps::Activate;
    const QString sentence = QString::fromStdString(error.message);
    m_steps->setState(UploadSteps::State::Failed, m_steps->current());
    m_showOutcome = [this, cancelled, unsure] {
        m_title->setText(cancelled ? tr("Cancelled")
                         : unsure  ? tr("Activation not confirmed")
                                   : tr("Not written"));
        m_note->setText(unsure ? tr("Look at the device to see which table is in use.")
                               : tr("The table that was in use still is."));
    };
    m_showOutcome();
    showWord(sentence, int(cancelled ? Tone::Plain : Tone::Bad));
    emit told(!cancelled,
              cancelled ? tr("The upload was cancelled.")
              : unsure  ? tr("The activation was not confirmed.")
                        : tr("The table was not written."),
              sentence);
    emit stateChanged();
}

void DevicePanel::showUploaded(const TableUploadReport &report)
{
    showBytes(UploadSteps::Write, 1.0);
    showBytes(UploadSteps::ReadBack, 1.0);
    m_steps->setDetail(UploadSteps::Verify, crcText(report.crc));
    m_steps->setDetail(UploadSteps::Commit, tr("gen. %1").arg(report.generation));
    m_steps->setDetail(UploadSteps::Activate, tr("bank %1").arg(bankName(report.bank)));
    m_percent->setText(tr("%1 %").arg(100));
    m_title->setText(report.rolledBack ? tr("Rolled back")
                                       : tr("Bank %1 is in use").arg(bankName(report.bank)));
    showWord(checkText(report), int(report.rolledBack ? Tone::Bad : Tone::Good));
}

} // namespace driftbench
