// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A Qt plugin that tells a test what MeshLab shows: QT_QPA_GENERIC_PLUGINS=dialog_probe loads it into a
// program, and the file of the environment variable DIALOG_PROBE then always holds what the floating dialog
// and the open menu show, as JSON: {"title": ..., "widgets": [{"class", "text", "tooltip", "x", "y", "width",
// "height", "needs_width", "needs_height", "is_cut"}], "menu": [...]}, in pixels of the screen.

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QGenericPlugin>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSaveFile>
#include <QSlider>
#include <QTimer>

namespace
{

QString TextOf(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->currentText();
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) return line->text();
    return {};
}

/// What a person reads or uses, not the frames around it.
bool IsForPeople(const QWidget& widget)
{
    return qobject_cast<const QLabel*>(&widget) || qobject_cast<const QAbstractButton*>(&widget) ||
           qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
           qobject_cast<const QSlider*>(&widget);
}

/// Of its text: lines break where they may, so the height depends on the width.
QSize NeededSize(const QWidget& widget)
{
    if (widget.hasHeightForWidth())
        return {widget.minimumSizeHint().width(), widget.heightForWidth(widget.width())};
    return widget.minimumSizeHint();
}

QJsonObject Describe(const QWidget& widget)
{
    const QRect place(widget.mapToGlobal({0, 0}), widget.size());
    const QSize needed = NeededSize(widget);
    return {{"class", widget.metaObject()->className()},
            {"text", TextOf(widget)},
            {"tooltip", widget.toolTip()},
            {"x", place.x()},
            {"y", place.y()},
            {"width", place.width()},
            {"height", place.height()},
            {"needs_width", needed.width()},
            {"needs_height", needed.height()},
            {"is_cut", widget.visibleRegion().boundingRect() != widget.rect()}};
}

QJsonArray WidgetsOf(const QDockWidget& dialog)
{
    QJsonArray widgets;
    for (const QWidget* widget : dialog.widget()->findChildren<QWidget*>())
        if (widget->isVisible() && IsForPeople(*widget)) widgets.append(Describe(*widget));
    return widgets;
}

QJsonArray TextsOf(const QMenu& menu)
{
    QJsonArray texts;
    for (const QAction* action : menu.actions()) texts.append(action->text());
    return texts;
}

QJsonObject Shown()
{
    QJsonObject shown{{"title", ""}, {"widgets", QJsonArray()}, {"menu", QJsonArray()}};
    for (const QWidget* window : QApplication::topLevelWidgets()) {
        if (!window->isVisible()) continue;
        if (const auto* menu = qobject_cast<const QMenu*>(window)) shown["menu"] = TextsOf(*menu);
        const auto* dialog = qobject_cast<const QDockWidget*>(window);
        if (!dialog || !dialog->isFloating() || !dialog->widget()) continue;
        shown["title"] = dialog->windowTitle();
        shown["widgets"] = WidgetsOf(*dialog);
    }
    return shown;
}

class Probe : public QObject
{
  public:
    explicit Probe(const QString& name)
    {
        constexpr int kMilliseconds = 100;
        auto* timer = new QTimer(this);
        connect(timer, &QTimer::timeout, this, [name] {
            QSaveFile file(name);
            file.open(QIODevice::WriteOnly);
            file.write(QJsonDocument(Shown()).toJson());
            file.commit();
        });
        timer->start(kMilliseconds);
    }
};

} // namespace

class DialogProbe : public QGenericPlugin
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "dialog_probe.json")

  public:
    QObject* create(const QString&, const QString&) override
    {
        return new Probe(qEnvironmentVariable("DIALOG_PROBE"));
    }
};

#include "dialog_probe.moc"
