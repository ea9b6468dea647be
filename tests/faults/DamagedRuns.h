#pragma once
// Going on with runs whose run file was damaged.

namespace vesicle::test
{

/// Damages the file of a run that was killed, in `count` ways, the same each time: bits, bytes and
/// blocks in any place, cuts. Expects of each --resume a refusal that changes no file, or the files
/// of an undisturbed run.
void expect_damage_to_be_noticed(int count);

}
