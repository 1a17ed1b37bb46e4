# samplers.awk PROGRAMS DECLARATIONS: no two samplers of a program have the same texture unit, an element of an array
# each, and no stage has more than 21. OpenGL promises 16, its drivers for 4.5 offer 32. PROGRAMS has a line
# "PROGRAM SHADER" for each stage, DECLARATIONS a line "SHADER layout(binding = UNIT) uniform TYPE NAME;" for each sampler.
function sum(text,    parts, i, total) {
    gsub(/[() ]/, "", text)
    for (i = split(text, parts, "+"); i; i--)
        total += parts[i]
    return total
}
FNR == NR { stages[$1] = stages[$1] " " $2; next }
{
    found = 1
    split($0, parts, /binding = |\) *uniform |;/)
    name = parts[3]
    sub(/.* /, "", name)
    size = match(name, /\[.*\]/) ? sum(substr(name, RSTART + 1, RLENGTH - 2)) : 1
    for (i = 0; i < size; i++)
        units[$1] = units[$1] " " sum(parts[2]) + i "=" name
}
END {
    for (program in stages) {
        split("", taken)
        for (s = split(stages[program], shaders); s; s--) {
            count = split(units[shaders[s]], pairs)
            if (count > 21)
                said["a stage has " count " samplers:" units[shaders[s]]]
            for (i = 1; i <= count; i++) {
                split(pairs[i], pair, "=")
                if (taken[pair[1]] && taken[pair[1]] != pair[2])
                    said["unit " pair[1] " of a program is that of " taken[pair[1]] " and of " pair[2]]
                taken[pair[1]] = pair[2]
            }
        }
    }
    if (!found)
        said["no shader has a sampler"]
    for (text in said) {
        print text
        bad = 1
    }
    exit bad
}
