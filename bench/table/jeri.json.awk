# All pictures for the JERI viewer: a tab for each scene and size, with the reference and the methods. Paths are relative
# to the folder. JERI finds a tab by its title, so no other method may have the reference's.
function quoted(text) {
    gsub(/\\/, "&&", text)
    gsub(/"/, "\\\"", text)
    return "\"" text "\""
}
# As `run` names folders.
function slug(text) {
    gsub(/[^A-Za-z0-9._+-]/, "-", text)
    gsub(/--+/, "-", text)
    sub(/^-*/, "", text)
    sub(/-*$/, "", text)
    return text
}
function image(title, path) {
    return "\n   {\"title\": " quoted(title) ", \"image\": " quoted(path) "}"
}
END {
    sort_sizes()
    printf "{\"title\": \"root\", \"children\": ["
    for (i = 1; i <= scene_count; i++)
        for (j = 1; j <= size_count; j++) {
            list = ""
            for (row = 1; row <= rows; row++)
                if (text[row, "scene"] == scenes[i] && text[row, "size"] == sizes[j] && text[row, "status"] == "ok") {
                    name = scenes[i] "." sizes[j] ".exr"
                    list = list "," image(text[row, "method"] (device_count > 1 ? ", " text[row, "device"] : ""), "entries/" slug(text[row, "method"]) "/" name)
                }
            if (list == "")
                continue
            printf "%s\n {\"title\": %s, \"children\": [%s%s]}", tab++ ? "," : "", quoted(scenes[i] " " sizes[j]),
                image("path-traced reference", "references/" scenes[i] "." sizes[j] ".exr"), list
        }
    print "\n]}"
}
