#!/bin/sh
# The IESLoader of three.js 0.187.0 gives negative intensities. Files of lamps that shine down have
# vertical angles from 0 to 90 degrees, and no light above [LM-63]. The loader extrapolates through
# the last two angles, up to 180 degrees, so a lamp whose light falls towards the horizon takes
# light away from the ceiling.
# The file is valid: 100 cd straight down, 70.7 cd at 45 degrees, 20 cd at 90 degrees. The loader scales the largest to 1.
#
# Seen with three 0.187.0 and Node.js 20.20.2:
#     0: 1.00, 45: 0.70, 89: 0.21, 120: -0.15, 179: -0.81
#
# Needs npm and node. Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix "$folder" three@0.187.0 > npm.log 2>&1 || exit 2
printf '%s\n' 'IESNA:LM-63-2002' '[TEST] down' 'TILT=NONE' '1 -1 1 3 1 1 2 0 0 0' '1 1 10' '0 45 90' '0' '100 70.7 20' > down.ies
cat > down.mjs <<'JS'
import {readFileSync} from 'fs';
import {FloatType} from 'three';
import {IESLoader} from 'three/examples/jsm/loaders/IESLoader.js';
const loader = new IESLoader();
loader.type = FloatType;
const light = loader.parse(readFileSync('down.ies', 'utf8')).image.data;
console.log([0, 45, 89, 120, 179].map(angle => `${angle}: ${light[angle].toFixed(2)}`).join(', '));
process.exit(light[120] < -.1 && light[179] < -.7 ? 0 : 1);
JS
node down.mjs
