# Of a page's badge, as shields.io takes it (endpoint).
END {
    printf "{\"schemaVersion\": 1, \"label\": \"table\", \"message\": \"%d scenes, %d methods, %d rows, %d failed\", \"color\": \"%s\"}\n",
        scene_count, method_count, rows, failed, failed ? "orange" : "blue"
}
