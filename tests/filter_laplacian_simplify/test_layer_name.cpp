// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <string>

#include <QtTest>

#include "layer_name.h"

using namespace laplacian_simplify;

class TestLayerName : public QObject
{
    Q_OBJECT

  private slots:
    void aLabelKeepsItsExtension_data()
    {
        QTest::addColumn<QString>("original");
        QTest::addColumn<QString>("label");
        QTest::addRow("file") << "flange.ply"
                              << "flange_simplified.ply";
        QTest::addRow("digit first") << "part.3mf"
                                     << "part_simplified.3mf";
        QTest::addRow("dots") << "part.v2.PLY"
                              << "part.v2_simplified.PLY";
        QTest::addRow("no extension") << "Box"
                                      << "Box_simplified";
        QTest::addRow("number") << "error 0.5"
                                << "error 0.5_simplified";
        QTest::addRow("measure") << "part 1.5mm"
                                 << "part 1.5mm_simplified";
        QTest::addRow("capitals") << "PART.3DS"
                                  << "PART_simplified.3DS";
        QTest::addRow("percent") << "error 0.5%"
                                 << "error 0.5%_simplified";
        QTest::addRow("sentence") << "Dr. Smith's part"
                                  << "Dr. Smith's part_simplified";
        QTest::addRow("hidden file") << ".ply"
                                     << ".ply_simplified";
        QTest::addRow("dot last") << "part."
                                  << "part._simplified";
        QTest::addRow("empty") << ""
                               << "_simplified";
        QTest::addRow("UTF-8") << QString::fromUtf8("Bär.ply") << QString::fromUtf8("Bär_simplified.ply");
    }
    void aLabelKeepsItsExtension()
    {
        QFETCH(QString, original);
        QFETCH(QString, label);
        QCOMPARE(QString::fromStdString(LayerLabel(original.toStdString(), "_simplified")), label);
    }
};

QTEST_APPLESS_MAIN(TestLayerName)
#include "test_layer_name.moc"
