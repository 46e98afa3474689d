#include "completion.h"

#include <sstream>

namespace hinge {
namespace {

// `hinge completion names SCRIPT` reads the script's text and runs nothing: "parameter NAME" or "case NAME" a line.
constexpr const char* bash_functions = R"sh(
# Parameters or cases of a script, words by their first word in what hinge lists.
_hinge_names() {
  hinge completion names ${2:+"$2"} 2>/dev/null | sed -n "s/^$1 //p"
}

_hinge_files() {
  compgen -d -- "$cur"
  if [ "$1" = script ]; then compgen -f -X '!*.lua' -- "$cur"; fi
}

_hinge() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} verb= script= word= words= i=1
  local IFS=$'\n'
  COMPREPLY=()
  while [ $i -lt $COMP_CWORD ]; do
    word=${COMP_WORDS[i]}
    case $word in
      *.lua) script=${script:-$word}; verb=${verb:-run} ;;
      -*) ;;
      *) verb=${verb:-$word} ;;
    esac
    i=$((i + 1))
  done
  if [ -z "$verb" ]; then
    COMPREPLY=($(compgen -W "$(_hinge_verbs)" -- "$cur"; _hinge_files script))
    _hinge_option filenames
    return
  fi
  case $prev in
    --case)
      [ -n "$script" ] && COMPREPLY=($(compgen -W "$(_hinge_names case "$script")" -- "$cur"))
      return ;;
    --out) COMPREPLY=($(_hinge_files)); _hinge_option filenames; return ;;
  esac
  if _hinge_takes_value "$verb" "$prev"; then return; fi
  case $cur in
    -*) COMPREPLY=($(compgen -W "$(_hinge_options "$verb")" -- "$cur")); return ;;
  esac
  case $(_hinge_kind "$verb") in
    script)
      if [ -z "$script" ]; then
        COMPREPLY=($(_hinge_files script))
        _hinge_option filenames
      elif [ "$cur" != = ] && [ "$prev" != = ]; then
        COMPREPLY=($(compgen -S = -W "$(_hinge_names parameter "$script")" -- "$cur"))
        _hinge_option nospace
      fi ;;
    folder) COMPREPLY=($(_hinge_files)); _hinge_option filenames ;;
    call) COMPREPLY=($(compgen -W "$(_hinge_names call)" -- "$cur")) ;;
    shell) COMPREPLY=($(compgen -W "$(_hinge_shells)" -- "$cur")) ;;
  esac
  return 0
}

# zsh has no compopt.
_hinge_option() {
  compopt -o $1 2>/dev/null
  return 0
}

complete -F _hinge hinge
)sh";

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

/// What a verb takes first: a script, a folder, a call of the reference, a shell, or "" for anything else.
std::string kind_of(const CLI::App& verb) {
    for (const CLI::Option* option : verb.get_options()) {
        if (!option->get_positional()) continue;
        std::string name = option->get_name(true);
        if (name == "script" || name == "folder" || name == "shell") return name;
        if (name == "folders") return "folder";
        if (name == "name" && verb.get_name() == "reference") return "call";
        return "";
    }
    return "";
}

/// The names of its options; `with_value`: only of those that a value follows.
std::vector<std::string> options_of(const CLI::App& verb, bool with_value) {
    std::vector<std::string> names;
    for (const CLI::Option* option : verb.get_options()) {
        if (with_value && option->get_expected_min() == 0) continue;
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

/// A shell function that prints what it has for its first argument, a verb.
template <class F>
void write_table(std::ostream& out, const CLI::App& app, const char* name, F&& of) {
    out << name << "() {\n  case $1 in\n";
    for (const CLI::App* verb : verbs_of(app))
        if (const std::string text = of(*verb); !text.empty())
            out << "    " << verb->get_name() << ") printf '%s\\n' " << text << " ;;\n";
    out << "  esac\n}\n";
}

std::string bash_script(const CLI::App& app) {
    std::ostringstream out;
    std::vector<std::string> names;
    for (const CLI::App* verb : verbs_of(app)) names.push_back(verb->get_name());
    for (const std::string& name : options_of(app, false)) names.push_back(name);
    out << "_hinge_verbs() { printf '%s\\n' " << joined(names, " ") << "; }\n";
    out << "_hinge_shells() { printf '%s\\n' " << joined(completed_shells, " ") << "; }\n";
    write_table(out, app, "_hinge_options", [](const CLI::App& v) { return joined(options_of(v, false), " "); });
    write_table(out, app, "_hinge_kind", kind_of);
    out << "# Whether a value follows that is not completed.\n_hinge_takes_value() {\n  case $1:$2 in\n";
    for (const CLI::App* verb : verbs_of(app))
        for (const std::string& name : options_of(*verb, true))
            if (name != "--case" && name != "--out")
                out << "    " << verb->get_name() << ":" << name << ") return 0 ;;\n";
    out << "  esac\n  return 1\n}\n" << bash_functions;
    return out.str();
}

/// The first sentence of a description, or what stands before its first ';' or ':', for a line of fish's list.
std::string short_text(const std::string& description) {
    std::string text = description.substr(0, description.find_first_of(";:("));
    while (!text.empty() && text.back() == ' ') text.pop_back();
    for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

std::string fish_script(const CLI::App& app) {
    std::ostringstream out;
    out << R"sh(function _hinge_script
  string match -r '.+\.lua$' -- (commandline -opc) | head -n 1
end
function _hinge_runs
  set -l words (commandline -opc)
  test (count $words) -gt 1; and string match -q -r '^run$|.\.lua$' -- $words[2]
end
function _hinge_names
  set -l script (_hinge_script)
  hinge completion names $script 2>/dev/null | string replace -f -r "^$argv[1] (.*)" "\$1$argv[2]"
end
complete -c hinge -f
complete -c hinge -n __fish_use_subcommand -a '(__fish_complete_suffix .lua)'
)sh";
    for (const CLI::App* verb : verbs_of(app))
        out << "complete -c hinge -n __fish_use_subcommand -a " << verb->get_name() << " -d '"
            << short_text(verb->get_description()) << "'\n";
    for (const CLI::App* verb : verbs_of(app)) {
        const bool is_run = verb->get_name() == "run";
        const std::string seen = "complete -c hinge -n " +
                                 (is_run ? "_hinge_runs " : "'__fish_seen_subcommand_from " + verb->get_name() + "' ");
        for (const CLI::Option* option : verb->get_options()) {
            std::string names;
            for (const std::string& name : option->get_lnames()) names += "-l " + name + " ";
            for (const std::string& name : option->get_snames()) names += "-s " + name + " ";
            if (names.empty()) continue;
            out << seen << names;
            if (option->get_expected_min() > 0) out << "-r ";
            if (option->check_lname("case")) out << "-a '(_hinge_names case)' ";
            if (option->check_lname("out")) out << "-a '(__fish_complete_directories)' ";
            out << "-d '" << short_text(option->get_description()) << "'\n";
        }
        const std::string kind = kind_of(*verb);
        if (kind == "script") {
            out << seen << "-a '(__fish_complete_suffix .lua)'\n";
            out << seen << "-a '(_hinge_names parameter =)'\n";
        }
        if (kind == "folder") out << seen << "-a '(__fish_complete_directories)'\n";
        if (kind == "call") out << seen << "-a '(_hinge_names call)'\n";
        if (kind == "shell") out << seen << "-a '" << joined(completed_shells, " ") << "'\n";
    }
    return out.str();
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell) {
    if (shell == "fish") return "# hinge completion fish | source\n" + fish_script(app);
    if (shell == "zsh")
        return "# source <(hinge completion zsh)\nautoload -U +X bashcompinit && bashcompinit\n" + bash_script(app);
    return "# source <(hinge completion bash)\n" + bash_script(app);
}

}  // namespace hinge
