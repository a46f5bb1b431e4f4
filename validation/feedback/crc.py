"""Check of random EnDat words, by crccheck: written to words.csv, which crates/feedback/tests/it/other_hands.rs reads.

    pip install crccheck==1.3.1
    python crc.py > words.csv
"""

import random
from importlib.metadata import version

from crccheck.crc import Crc

# Width, polynomial, initial value, reflected in and out, final inversion: x^5 + x^3 + x + 1.
CRC = Crc(5, 0x0B, 0x1F, False, False, 0x1F)
random.seed(30)
print(f"# crccheck {version('crccheck')}; seed 30; 24, 32 and 40 bits: the library takes whole bytes")
print("bits,crc")
for index in range(600):
    size = (3, 4, 5)[index % 3]
    data = random.randbytes(size)
    word = "".join(f"{byte:08b}" for byte in data)
    print(f"{word},{CRC.calc(data):05b}")
