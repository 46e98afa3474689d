#include "effects/removal.h"

#include "script/bind/model_methods.h"

namespace hinge::script {

/// model:remove { member = | group =, at = s, over = s }
int remove_members(lua_State* L) {
    auto& model = self<ModelBox>(L, "model:remove").value;
    if (model->options().mass == MassShape::cubic)
        throw InputError("model:remove: a model with mass = 'cubic' cannot break; leave out one of the two");
    Options o(L, 2, "model:remove");
    o.expect({"member", "group", "at", "over"});
    Removal removal;
    if (o.has("member")) {
        if (o.has("group")) o.complain("group", "given beside member", "give one of the two");
        o.push_field("member");
        removal.member = member_argument(L, -1, "model:remove: field 'member'", model.get()).index;
        lua_pop(L, 1);
    } else if (o.push_field("group") != LUA_TNIL) {
        removal.group = group_argument(L, -1, "model:remove: field 'group'", *model);
        lua_pop(L, 1);
    } else {
        throw InputError("model:remove: field 'member' is missing; give a member, or group = a group");
    }
    removal.at = o.number("at", "s", Range::not_negative);
    removal.over = o.number("over", "s", Range::not_negative, 0);
    removal.asked_at = where(L);
    model->declare(removal_effect, removal);
    model->ask(removal_effect, where(L));  // its line in the plan
    return 0;
}

}  // namespace hinge::script
