#include "app/gui/pages/export_page.h"

#include "app/gui/app_context.h"
#include "app/gui/banner_of.h"
#include "app/gui/export/device_panel.h"
#include "app/gui/export/file_choices.h"
#include "app/gui/page_head.h"
#include "app/gui/train/model_words.h"
#include "app/gui/workbench.h"
#include "engine/base/axes.h"
#include "widgets/controls/section_head.h"
#include "widgets/style/number_text.h"
#include "widgets/tables/knots_table_model.h"
#include "widgets/views/table_error_view.h"

#include <QAction>
#include <QComboBox>
#include <QPlainTextEdit>
#include <QStackedWidget>

namespace driftbench {

static constexpr int kImageForm = 6;
static constexpr qsizetype kMostShownLetters = 400000;

static QString unitText(const FixedPointTable &fixed)
{
    return ExportPage::tr("int32, 1 LSB = 2%1 dps = %2 µdps")
        .arg(raisedText(-fixed.fractionBits))
        .arg(numberText(1e6 * fixed.dpsPerUnit(), 3));
}

// Of axes that are left out, or written though they have no yes.
static std::function<BannerContent()> aboutAxes(const std::array<bool, 3> &compensated)
{
    QStringList left;
    for (std::size_t axis = 0; axis < compensated.size(); ++axis) {
        if (!compensated[axis])
            left.append(QString::fromUtf8(kAxisNames[axis].data()));
    }
    const QString axes = left.join(QStringLiteral(", "));
    if (left.isEmpty())
        return bannerOf(
            BannerKind::Caution, [] { return ExportPage::tr("Axes without a yes are written too."); },
            [] { return ExportPage::tr("Compare says what that costs on runs held out."); });
    return bannerOf(
        BannerKind::Info, [axes] { return ExportPage::tr("No table for %1.").arg(axes); },
        [] {
            return ExportPage::tr(
                "It does not help on runs held out; Compare has the figures. Its values are zero.");
        });
}

void ExportPage::showPreview()
{
    const Session &session = context().workbench->session();
    const TrainedModel *model = session.chosenModel();
    m_stack->setCurrentIndex(model != nullptr ? 1 : 0);
    head().setOrigin(model == nullptr ? Origin::None : model->simulated ? Origin::Simulated : Origin::Real);
    const auto table = m_preview ? m_preview->table : nullptr;
    m_knotsModel->setData(table);
    const double limit = session.exportChoice().options.table.maxInterpolationErrorDps.value_or(
        TableOptions::kDefaultErrorDps);
    m_errors->setData(table, kMdpsPerDps * limit);
    m_errors->setOrigin(model != nullptr && model->simulated ? OriginChip::words(Origin::Simulated)
                                                             : QString());
    m_tableHead->setNote(table ? unitText(table->fixed) : QString());
    m_files->setPreview(m_preview.get());
    m_device->setPreview(m_preview, model);
    if (m_preview && m_preview->refusal)
        banners().post(QString::fromLatin1(kNotes),
                       bannerOf(BannerKind::Caution, tr("There is no table to write."),
                                QString::fromStdString(m_preview->refusal->message)));
    else if (m_preview && !m_preview->notes.empty())
        banners().post(QString::fromLatin1(kNotes), aboutAxes(m_preview->compensated));
    else
        banners().withdraw(QString::fromLatin1(kNotes));
    if (model == nullptr)
        head().setContext(tr("The table for the device"));
    else if (table)
        head().setContext(tr("Table of %1 rows, %2 °C apart.")
                              .arg(table->table.size())
                              .arg(numberText(table->table.stepC(), 3)));
    else
        head().setContext({});
    showForm();
    showButtons();
}

static QString hexDump(const std::vector<std::uint8_t> &bytes)
{
    QString text;
    for (std::size_t i = 0; i < bytes.size() && text.size() < kMostShownLetters; ++i) {
        if (i % 16 == 0)
            text += QStringLiteral("%1%2 ")
                        .arg(i == 0 ? QString() : QStringLiteral("\n"))
                        .arg(i, 6, 16, QLatin1Char('0'));
        text += QStringLiteral(" %1").arg(bytes[i], 2, 16, QLatin1Char('0'));
    }
    return text;
}

QString ExportPage::previewText() const
{
    const int form = m_form->currentIndex();
    if (form <= 0 || !m_preview)
        return {};
    if (form == kImageForm)
        return m_preview->imageRefusal ? QString::fromStdString(m_preview->imageRefusal->message)
                                       : hexDump(m_preview->image);
    const FilePreview *file = m_preview->file(static_cast<ExportFormat>(form - 1));
    if (file == nullptr)
        return {};
    return QString::fromStdString(file->refusal ? file->refusal->message : file->exported.text)
        .left(kMostShownLetters);
}

void ExportPage::choosePreview(int form)
{
    m_form->setCurrentIndex(form);
}

void ExportPage::showForm()
{
    const bool text = m_form->currentIndex() > 0;
    m_forms->setCurrentIndex(text ? 1 : 0);
    if (text)
        m_text->setPlainText(previewText());
}

void ExportPage::showButtons()
{
    if (m_device == nullptr)
        return;
    const bool table = m_preview && m_preview->table;
    m_save->setEnabled(table && m_files->chosen() > 0 && !m_saving.isRunning());
    m_write->setEnabled(m_device->canWrite());
    m_restore->setEnabled(m_device->canRestore());
    m_cancel->setEnabled(m_device->isWriting());
    m_write->setToolTip(m_write->isEnabled() ? tr("Into the spare bank; the one in use stays until the end")
                        : !table             ? tr("There is no table to write")
                        : m_preview->imageRefusal ? QString::fromStdString(m_preview->imageRefusal->message)
                        : m_device->isWriting()   ? tr("A table is being written")
                                                  : tr("No device with tables is there"));
    emit stateChanged();
}

} // namespace driftbench
