#include "app/gui/export/file_choices.h"

#include "engine/base/axes.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/section_head.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace driftbench {

static constexpr int kImage = 5;
static constexpr double kShownLossMdps = 0.05; // with one decimal
static constexpr int kNameWidth = 116;

FileChoices::FileChoices(QWidget *parent)
    : QWidget(parent)
    , m_head(new SectionHead)
    , m_force(new QCheckBox)
    , m_idLabel(new TextLabel(TextRole::Muted))
    , m_boundLabel(new TextLabel(TextRole::Muted))
    , m_deviceId(new QLineEdit)
    , m_bound(new NumberField({}, tr("mdps"), 2, 0.01, 1000.0, 0.1))
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_head);
    auto *grid = new QGridLayout;
    grid->setVerticalSpacing(0);
    grid->setHorizontalSpacing(kLabelGap);
    grid->setColumnMinimumWidth(0, kNameWidth);
    grid->setColumnStretch(1, 1);
    for (int file = 0; file < kFiles; ++file) {
        const auto at = static_cast<std::size_t>(file);
        m_boxes[at] = new QCheckBox;
        m_notes[at] = new TextLabel(TextRole::Note);
        m_notes[at]->setElided(true);
        grid->addWidget(m_boxes[at], file, 0);
        grid->addWidget(m_notes[at], file, 1);
        grid->setRowMinimumHeight(file, kControlHeight);
        connect(m_boxes[at], &QCheckBox::toggled, this, &FileChoices::takeBoxes);
    }
    rows->addLayout(grid);
    auto *last = new QHBoxLayout;
    last->setSpacing(kLabelGap);
    m_deviceId->setFixedWidth(96);
    m_idLabel->setBuddy(m_deviceId);
    m_boundLabel->setBuddy(m_bound);
    last->addWidget(m_boundLabel);
    last->addWidget(m_bound);
    last->addWidget(m_idLabel);
    last->addWidget(m_deviceId);
    last->addStretch(1);
    rows->addSpacing(4);
    rows->addLayout(last);
    rows->addSpacing(4);
    rows->addWidget(m_force);
    m_bound->setKeyboardTracking(false);
    connect(m_force, &QCheckBox::toggled, this, [this](bool on) {
        m_choice.options.force = on;
        if (!m_showing)
            emit edited(m_choice);
    });
    connect(m_bound, &QDoubleSpinBox::valueChanged, this, [this](double mdps) {
        m_choice.options.table.maxInterpolationErrorDps = mdps / kMdpsPerDps;
        if (!m_showing)
            emit edited(m_choice);
    });
    connect(m_deviceId, &QLineEdit::editingFinished, this, &FileChoices::takeDeviceId);
}

void FileChoices::takeBoxes()
{
    if (m_showing)
        return;
    m_choice.formats.clear();
    for (int file = 0; file < kImage; ++file) {
        if (m_boxes[static_cast<std::size_t>(file)]->isChecked())
            m_choice.formats.push_back(static_cast<ExportFormat>(file));
    }
    emit edited(m_choice);
    emit chosenChanged();
}

void FileChoices::takeDeviceId()
{
    bool number = false;
    const quint32 id = m_deviceId->text().trimmed().toUInt(&number, 0);
    const auto wanted = number ? std::optional<std::uint32_t>(id) : std::nullopt;
    m_deviceId->setProperty("invalid", !number && !m_deviceId->text().trimmed().isEmpty());
    m_deviceId->update();
    if (m_showing || m_choice.options.deviceId == wanted)
        return;
    m_choice.options.deviceId = wanted;
    emit edited(m_choice);
}

void FileChoices::show(const ExportChoice &choice)
{
    m_showing = true;
    m_choice = choice;
    for (int file = 0; file < kImage; ++file) {
        const bool on = std::find(choice.formats.begin(), choice.formats.end(),
                                  static_cast<ExportFormat>(file)) != choice.formats.end();
        m_boxes[static_cast<std::size_t>(file)]->setChecked(on);
    }
    m_force->setChecked(choice.options.force);
    m_bound->setValue(kMdpsPerDps *
                      choice.options.table.maxInterpolationErrorDps.value_or(TableOptions::kDefaultErrorDps));
    if (!m_deviceId->hasFocus())
        m_deviceId->setText(choice.options.deviceId ? QString::number(*choice.options.deviceId) : QString());
    m_showing = false;
    showNotes();
}

void FileChoices::setPreview(const ExportPreview *preview)
{
    m_preview = preview;
    showNotes();
}

bool FileChoices::imageChosen() const
{
    return m_boxes[kImage]->isChecked();
}

int FileChoices::chosen() const
{
    return static_cast<int>(
        std::count_if(m_boxes.begin(), m_boxes.end(), [](const QCheckBox *box) { return box->isChecked(); }));
}

void FileChoices::note(int file, const QString &text, int tone)
{
    TextLabel &label = *m_notes[static_cast<std::size_t>(file)];
    label.setTone(static_cast<Tone>(tone));
    label.setText(text);
    m_boxes[static_cast<std::size_t>(file)]->setAccessibleDescription(text);
}

// What a cubic costs against the model, on the axis where it costs most.
void FileChoices::noteAutopilot(const FilePreview &file)
{
    const int row = static_cast<int>(file.format);
    if (file.refusal && file.format == ExportFormat::Px4 && !m_choice.options.deviceId)
        return note(row, tr("needs the gyro's device id, below"), int(Tone::Caution));
    if (file.refusal)
        return note(row, QString::fromStdString(file.refusal->message), int(Tone::Bad));
    Eigen::Index axis = 0;
    const double loss = m_preview->cubic.largestLossDps.maxCoeff(&axis);
    const QString name = QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data());
    if (!(kMdpsPerDps * loss >= kShownLossMdps))
        return note(row, tr("cubic, loses nothing"), int(Tone::Plain));
    note(row,
         tr("cubic only: up to %1 mdps off on %2, %3 rms")
             .arg(numberText(kMdpsPerDps * loss, 1), name,
                  numberText(kMdpsPerDps * m_preview->cubic.rmsLossDps[axis], 1)),
         int(Tone::Caution));
}

void FileChoices::showNotes()
{
    m_head->setNote(tr("%1 of %2 chosen").arg(chosen()).arg(kFiles));
    const bool there = m_preview != nullptr && m_preview->table;
    for (int file = 0; file < kFiles; ++file) {
        m_boxes[static_cast<std::size_t>(file)]->setEnabled(there);
        if (!there)
            note(file, {}, int(Tone::Plain));
    }
    if (!there)
        return;
    const auto rows = static_cast<int>(m_preview->table->table.size());
    note(0, tr("table, %n row(s)", nullptr, rows), int(Tone::Plain));
    note(1, tr("table in both kinds and where it comes from, exact"), int(Tone::Plain));
    for (const FilePreview &file : m_preview->files) {
        const int row = static_cast<int>(file.format);
        if (file.format == ExportFormat::Px4 || file.format == ExportFormat::ArduPilot)
            noteAutopilot(file);
        else if (file.refusal)
            note(row, QString::fromStdString(file.refusal->message), int(Tone::Bad));
        else if (file.format == ExportFormat::C)
            note(row,
                 tr("float and fixed point, %1 bytes").arg(numberText(double(file.exported.text.size()), 0)),
                 int(Tone::Plain));
    }
    const SensorIdentity &sensor = m_preview->table->table.provenance.sensor;
    if (m_preview->imageRefusal && (sensor.model.empty() || sensor.serial.empty()))
        note(kImage, tr("needs the sensor's name: state it when you open the log"), int(Tone::Caution));
    else if (m_preview->imageRefusal)
        note(kImage, QString::fromStdString(m_preview->imageRefusal->message), int(Tone::Bad));
    else
        note(kImage, tr("one bank, %1 bytes").arg(numberText(double(m_preview->image.size()), 0)),
             int(Tone::Plain));
}

void FileChoices::retranslate()
{
    m_head->setTitle(tr("Files"));
    const std::array<QString, kFiles> names{
        tr("CSV"), tr("JSON"), tr("C header"), tr("PX4 .params"), tr("ArduPilot .parm"), tr("Device image")};
    for (std::size_t file = 0; file < names.size(); ++file)
        m_boxes[file]->setText(names[file]);
    m_force->setText(tr("Also axes without a yes"));
    m_force->setToolTip(
        tr("Axes whose verdict is not yes are left out unless this is on; the files say so."));
    m_boundLabel->setText(tr("Largest error"));
    m_bound->setAccessibleName(tr("Largest interpolation error"));
    m_idLabel->setText(tr("PX4 device id"));
    m_deviceId->setAccessibleName(tr("PX4 device id"));
    m_deviceId->setToolTip(
        tr("By which PX4 knows the gyro again: its parameter TC_G0_ID. Empty: the serial number."));
    showNotes();
}

} // namespace driftbench
