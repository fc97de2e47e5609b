// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// script_runner [--cancel] MESH SCRIPT OUTPUT FOLDER...
// What meshlabserver was, for the versions that have none: loads the plugins of the folders by the host's own
// plugin manager, runs the filters of the script on the mesh and writes it. Prints the log and what the
// filters return. With --cancel every progress call asks the filter to stop. Ends with 1, and writes nothing,
// where a filter failed.

#include <cstdio>
#include <exception>
#include <stdexcept>

#include <QApplication>
#include <QDir>

#include <common/filterscript.h>
#include <common/globals.h>
#include <common/plugins/interfaces/filter_plugin.h>
#include <common/plugins/plugin_manager.h>
#include <common/utilities/load_save.h>

namespace
{

bool g_cancel = false; // the host's callback is a plain function

bool OnProgress(const int, const char*)
{
    return !g_cancel;
}

void Print(const std::map<std::string, QVariant>& results)
{
    for (const auto& [name, value] : results)
        std::printf("%s = %s\n", name.c_str(), qUtf8Printable(value.toString()));
}

void RunFilter(PluginManager& plugins, MeshDocument& document, const QString& name,
               const RichParameterList& parameters)
{
    const QAction* action = plugins.filterAction(name);
    if (!action) throw std::runtime_error("no plugin has the filter " + name.toStdString());
    FilterPlugin* filter = plugins.getFilterPluginFromAction(action);
    document.mm()->updateDataMask(filter->getRequirements(action));
    filter->setLog(&document.Log);
    unsigned int changed = MeshModel::MM_UNKNOWN;
    document.setBusy(true);
    Print(filter->applyFilter(action, parameters, document, changed, OnProgress));
    document.setBusy(false);
    // MeshLab then takes the filter's postCondition, as some of its own filters want; ours say what they did.
    if (changed == MeshModel::MM_UNKNOWN && filter->vendor() == "The Laplacian Simplify authors")
        throw std::runtime_error("the filter does not say what it changed");
}

void Run(const QStringList& arguments)
{
    if (arguments.size() < 4)
        throw std::runtime_error("usage: script_runner [--cancel] MESH SCRIPT OUTPUT FOLDER...");
    PluginManager& plugins = meshlab::pluginManagerInstance();
    for (const QString& folder : arguments.mid(3)) plugins.loadPlugins(QDir(folder));
    MeshDocument document;
    if (meshlab::loadMeshWithStandardParameters(arguments[0], document).empty())
        throw std::runtime_error("the mesh cannot be read");
    FilterScript script;
    if (!script.open(arguments[1])) throw std::runtime_error("the script cannot be read");
    for (const FilterNameParameterValuesPair& step : script)
        RunFilter(plugins, document, step.filterName(), step.second);
    meshlab::saveMeshWithStandardParameters(arguments[2], *document.mm());
}

} // namespace

int main(int argumentCount, char** arguments)
{
    const QApplication application(argumentCount, arguments);
    QStringList words = QCoreApplication::arguments().mid(1);
    g_cancel = words.removeAll("--cancel") > 0;
    try {
        Run(words);
    } catch (const std::exception& error) {
        std::printf("error: %s\n", error.what());
        return 1;
    }
    return 0;
}
