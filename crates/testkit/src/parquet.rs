//! Hand-made Parquet files, which can claim anything a test requires.

/// A structure in the compact protocol of Thrift. Fields come in the order of their numbers.
#[derive(Clone, Debug, Default)]
pub struct Structure {
    bytes: Vec<u8>,
    last: u8,
}

/// Encodes a number with seven bits per byte, as in the protocol.
#[must_use]
pub fn varint(mut number: u64) -> Vec<u8> {
    let mut bytes = Vec::new();
    while number >= 0x80 {
        bytes.push(0x80 | (number & 0x7f) as u8);
        number >>= 7;
    }
    bytes.push(number as u8);
    bytes
}

/// Encodes a number with its sign in the lowest bit.
#[must_use]
pub fn zigzag(number: i64) -> Vec<u8> {
    varint(((number << 1) ^ (number >> 63)).cast_unsigned())
}

impl Structure {
    fn field(mut self, id: u8, kind: u8, content: &[u8]) -> Self {
        self.bytes.push((id - self.last) << 4 | kind);
        self.bytes.extend(content);
        self.last = id;
        self
    }

    /// Adds an integer of 64 bits.
    #[must_use]
    pub fn integer(self, id: u8, number: i64) -> Self {
        self.field(id, 6, &zigzag(number))
    }

    /// Adds a boolean.
    #[must_use]
    pub fn truth(self, id: u8, truth: bool) -> Self {
        self.field(id, if truth { 1 } else { 2 }, &[])
    }

    /// Adds a text.
    #[must_use]
    pub fn text(self, id: u8, text: &str) -> Self {
        let content = [varint(text.len() as u64), text.as_bytes().to_vec()].concat();
        self.field(id, 8, &content)
    }

    /// Adds a structure.
    #[must_use]
    pub fn structure(self, id: u8, inner: Self) -> Self {
        let content = inner.end();
        self.field(id, 12, &content)
    }

    /// Adds a list of structures that claims to have `count` of them.
    #[must_use]
    pub fn list(self, id: u8, count: u64, inner: impl IntoIterator<Item = Self>) -> Self {
        let mut content = [vec![0xfc], varint(count)].concat();
        inner.into_iter().for_each(|each| content.extend(each.end()));
        self.field(id, 9, &content)
    }

    /// Returns the bytes with the end mark.
    #[must_use]
    pub fn end(mut self) -> Vec<u8> {
        self.bytes.push(0);
        self.bytes
    }
}

/// A column of a file: its pages are stored one after the other.
#[derive(Clone, Debug)]
pub struct FileColumn {
    /// Name of the column.
    pub name: &'static str,
    /// Type, as the number in the format: 1 INT32, 2 INT64, 4 FLOAT, 5 DOUBLE.
    pub physical: i64,
    /// Compression: 0 none, 1 snappy, 2 gzip, 6 zstd.
    pub codec: i64,
    /// Number of values claimed.
    pub values: i64,
    /// Pages with their headers.
    pub pages: Vec<u8>,
}

/// Creates a page of the first version with its header; unpacked size and number of values are claims.
#[must_use]
pub fn page(encoding: i64, values: i64, packed: &[u8], unpacked: i64) -> Vec<u8> {
    let head = Structure::default().integer(1, values).integer(2, encoding).integer(3, 3).integer(4, 3);
    let page = Structure::default().integer(1, 0).integer(2, unpacked).integer(3, packed.len() as i64);
    [page.structure(5, head).end(), packed.to_vec()].concat()
}

/// Creates a file with one row group of these columns.
#[must_use]
pub fn file(rows: i64, columns: &[FileColumn]) -> Vec<u8> {
    let mut bytes = b"PAR1".to_vec();
    let (mut schema, mut chunks) =
        (vec![Structure::default().text(4, "schema").integer(5, columns.len() as i64)], Vec::new());
    for column in columns {
        schema.push(Structure::default().integer(1, column.physical).integer(3, 0).text(4, column.name));
        let about = Structure::default()
            .integer(1, column.physical)
            .integer(4, column.codec)
            .integer(5, column.values)
            .integer(6, column.pages.len() as i64)
            .integer(7, column.pages.len() as i64)
            .integer(9, bytes.len() as i64);
        chunks.push(Structure::default().integer(2, 0).structure(3, about));
        bytes.extend(&column.pages);
    }
    let group = Structure::default().list(1, columns.len() as u64, chunks).integer(2, 0).integer(3, rows);
    let footer =
        Structure::default().integer(1, 2).list(2, schema.len() as u64, schema).integer(3, rows).list(4, 1, [group]);
    ended(bytes, footer.end())
}

/// Appends a footer to the bytes of a file.
#[must_use]
pub fn ended(mut bytes: Vec<u8>, footer: Vec<u8>) -> Vec<u8> {
    let length = u32::try_from(footer.len()).unwrap_or(u32::MAX).to_le_bytes();
    bytes.extend(footer);
    bytes.extend(length);
    bytes.extend(b"PAR1");
    bytes
}

/// Creates a file whose schema has nested groups, with a column in the innermost.
#[must_use]
pub fn nested_groups(depth: usize) -> Vec<u8> {
    let group = || Structure::default().text(4, "g").integer(5, 1);
    let column = Structure::default().integer(1, 5).text(4, "q");
    let schema = (0..depth).map(|_| group()).chain([column]);
    let footer = Structure::default().integer(1, 1).list(2, depth as u64 + 1, schema).integer(3, 0).list(4, 0, []);
    ended(b"PAR1".to_vec(), footer.end())
}

/// Creates a file whose schema has one group that claims 2³¹ − 1 children.
#[must_use]
pub fn claimed_children() -> Vec<u8> {
    let root = Structure::default().text(4, "s").integer(5, i64::from(i32::MAX));
    ended(b"PAR1".to_vec(), Structure::default().list(2, 1, [root]).end())
}

/// Encodes the integers 0, 1, 2 … as deltas of one in blocks of `block`, each of which takes a few bytes.
#[must_use]
pub fn ramp_of_deltas(count: u64, block: u64) -> Vec<u8> {
    let mut bytes = [varint(block), varint(1), varint(count), zigzag(0)].concat();
    for _ in 0..count.saturating_sub(1).div_ceil(block) {
        bytes.extend(zigzag(1));
        bytes.push(0);
    }
    bytes
}
