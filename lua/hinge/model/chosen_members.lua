-- The members that an option of a library call names: a list of members, or a group.
local check = require "hinge.library.check"

local chosen = {}

local function of_list(where, model, list)
  local all, seen = model:members(), {}
  if type(list) ~= "table" or #list == 0 then
    check.fail("%s: field 'members' is %s; must be a list of members, such as group:members() gives", where,
      type(list) == "table" and "empty" or check.show(list))
  end
  for i, member in ipairs(list) do
    if check.kind_of(member) ~= "member" or all[member.index] ~= member then
      check.fail("%s: field 'members[%d]' is %s; must be a member of this model", where, i, check.show(member))
    end
    if seen[member.index] then
      check.fail("%s: field 'members[%d]' is member %d, which is in the list twice", where, i, member.index)
    end
    seen[member.index] = true
  end
  return list
end

local function of_group(where, model, group)
  local names = {}
  for i, known in ipairs(model:groups()) do
    if known == group or known.name == group then return known:members() end
    names[i] = known.name
  end
  if type(group) == "string" then check.unknown(where, "group", group, names) end
  check.fail("%s: field 'group' is %s; must be a group of this model or its name", where, check.show(group))
end

--- The members by the fields `members` or `group` of which one must be given.
function chosen.members(where, model, members, group)
  if (members == nil) == (group == nil) then
    check.fail("%s: give either 'members' or 'group'%s", where, group ~= nil and "; both are given" or "")
  end
  if members ~= nil then return of_list(where, model, members) end
  return of_group(where, model, group)
end

--- The model of the field `model`.
function chosen.model(where, model)
  if check.kind_of(model) ~= "model" then
    check.fail("%s: field 'model' is %s; must be a model, made by hinge.model", where,
      model == nil and "missing" or check.show(model))
  end
  return model
end

return chosen
