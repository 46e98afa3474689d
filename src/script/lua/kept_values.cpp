#include "script/lua/kept_values.h"

#include "core/archive.h"
#include "script/lua/probe_list.h"

namespace hinge::script {
namespace {

enum class Tag : std::uint8_t {
    end,
    no,
    yes,
    whole,
    number,
    text,
    table
};  ///< a table: keys and values alternate, then end
constexpr int deepest = 100;

void pack(Writer& write, lua_State* L, int index, const std::string& what, int depth) {
    index = lua_absindex(L, index);
    switch (lua_type(L, index)) {
        case LUA_TBOOLEAN: return write(lua_toboolean(L, index) ? Tag::yes : Tag::no);
        case LUA_TNUMBER:
            if (lua_isinteger(L, index)) return write(Tag::whole, lua_tointeger(L, index));
            return write(Tag::number, lua_tonumber(L, index));
        case LUA_TSTRING: {
            std::size_t length;
            const char* text = ::lua_tolstring(L, index, &length);
            return write(Tag::text, std::string(text, length));
        }
        case LUA_TTABLE: break;
        default:
            throw InputError(what + " is " + show(L, index) +
                             "; only booleans, numbers, strings and tables of them can be kept");
    }
    if (depth > deepest || !lua_checkstack(L, 4))
        throw InputError(what + " is nested too deep to be kept; does a table hold itself?");
    write(Tag::table);
    fill_probe_list(L, index);
    lua_pushnil(L);
    while (lua_next(L, index)) {
        const int kind = lua_type(L, -2);
        const std::string name =
            kind == LUA_TSTRING ? what + "." + lua_tostring(L, -2) : what + "[" + show(L, -2) + "]";
        if (kind == LUA_TTABLE) throw InputError(name + ": a table that is a key cannot be kept");
        pack(write, L, -2, name, depth + 1);
        pack(write, L, -1, name, depth + 1);
        lua_pop(L, 1);
    }
    write(Tag::end);
}

struct Token {
    Tag tag = Tag::end;
    lua_Integer whole = 0;
    double number = 0;
    std::string text;
};

/// One value, whole; of a table all that is in it.
void read_value(Reader& read, std::vector<Token>& tokens, int depth, bool is_key) {
    Token& t = tokens.emplace_back();
    read(t.tag);
    read.must(t.tag <= Tag::table && depth <= deepest && !(is_key && (t.tag == Tag::table)));
    if (t.tag == Tag::whole) read(t.whole);
    if (t.tag == Tag::number) read(t.number), read.must(!(is_key && std::isnan(t.number)));
    if (t.tag == Tag::text) read(t.text);
    if (t.tag != Tag::table) return;
    while (true) {
        read_value(read, tokens, depth + 1, true);
        if (tokens.back().tag == Tag::end) return;
        const std::size_t value = tokens.size();
        read_value(read, tokens, depth + 1, false);
        read.must(tokens[value].tag != Tag::end);
    }
}

std::vector<Token> read_table(const std::string& bytes) {
    Reader read(bytes);
    std::vector<Token> tokens;
    read_value(read, tokens, 0, false);
    read.must(tokens[0].tag == Tag::table && read.rest().empty());
    return tokens;
}

/// Pushes the value that begins at `token` and leaves `token` behind it. Called under protect: nothing here has a
/// destructor.
void push_value(lua_State* L, const Token*& token) {
    const Token& t = *token++;
    luaL_checkstack(L, 4, nullptr);
    switch (t.tag) {
        case Tag::no:
        case Tag::yes: return lua_pushboolean(L, t.tag == Tag::yes);
        case Tag::whole: return lua_pushinteger(L, t.whole);
        case Tag::number: return lua_pushnumber(L, t.number);
        case Tag::text: ::lua_pushlstring(L, t.text.data(), t.text.size()); return;
        default: break;
    }
    ::lua_createtable(L, 0, 0);
    while (token->tag != Tag::end) {
        push_value(L, token);
        push_value(L, token);
        lua_rawset(L, -3);
    }
    ++token;
}

}  // namespace

std::string pack_table(lua_State* L, int index, const std::string& what) {
    std::string bytes;
    Writer write(bytes);
    pack(write, L, index, what, 0);
    return bytes;
}

void check_packed_table(const std::string& bytes) { read_table(bytes); }

void unpack_table(lua_State* L, int index, const std::string& bytes) {
    const std::vector<Token> tokens = read_table(bytes);
    lua_pushvalue(L, index);
    protect(L, 1, 0, [first = tokens.data()](lua_State* inner) {
        const Token* token = first;
        push_value(inner, token);
        for (lua_pushnil(inner); lua_next(inner, 1);) {  // out with the old
            lua_settop(inner, 3);
            lua_pushvalue(inner, 3);
            lua_pushnil(inner);
            lua_rawset(inner, 1);
        }
        for (lua_pushnil(inner); lua_next(inner, 2);) {
            lua_pushvalue(inner, 3);
            lua_rotate(inner, 4, 1);
            lua_rawset(inner, 1);
        }
        lua_settop(inner, 0);
    });
}

}  // namespace hinge::script
