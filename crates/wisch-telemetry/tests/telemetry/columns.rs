//! Binary tables of other programs: Parquet, Arrow and archives of NumPy arrays.

use super::tables::{COUNT, NAMES, assert_is_it, plain, table, time};
use super::{in_folder, refused};
use arrow_array::{
    ArrayRef, DurationNanosecondArray, Float64Array, RecordBatch, StringArray,
    TimestampNanosecondArray,
};
use arrow_array::{BooleanArray, Float32Array, Int8Array, ListArray, types::Float64Type};
use arrow_ipc::CompressionType;
use arrow_ipc::writer::{FileWriter, IpcWriteOptions, StreamWriter};
use parquet::basic::{Compression, ZstdLevel};
use parquet::data_type::{ByteArrayType, DoubleType, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use proptest::prelude::*;
use std::fs;
use std::io::{Cursor, Write};
use std::sync::{Arc, LazyLock};
use wisch_telemetry::{Log, LogOptions, ReadFault, read};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// A column: its name and numbers; missing numbers are NaN.
type Reals = (String, Vec<f64>);

/// Converts the log of `table` from text to columns.
fn columns(text: &str) -> Vec<Reals> {
    let mut lines = text.lines();
    let names = lines.next().unwrap().split(',');
    let mut columns: Vec<Reals> = names.map(|name| (name.to_owned(), Vec::new())).collect();
    for line in lines {
        for (column, value) in columns.iter_mut().zip(line.split(',')) {
            column.1.push(value.parse().unwrap_or(f64::NAN));
        }
    }
    columns
}

/// Returns the time of each sample [ns since 1970]; a float does not hold them.
fn dates() -> Vec<i64> {
    let nanoseconds = (0..COUNT).map(|tick| (time(tick) * 1e9).round() as i64);
    nanoseconds
        .map(|time| 1_760_000_000_000_000_001 + time)
        .collect()
}

fn array(values: &[f64]) -> ArrayRef {
    let values = values
        .iter()
        .map(|value| (!value.is_nan()).then_some(*value));
    Arc::new(values.collect::<Float64Array>())
}

fn batch_of(columns: &[Reals]) -> RecordBatch {
    let columns = columns
        .iter()
        .map(|(name, values)| (name, array(values), true));
    RecordBatch::try_from_iter_with_nullable(columns).unwrap()
}

/// Returns a batch with one column replaced.
fn batch_with(columns: &[Reals], name: &str, array: &ArrayRef) -> RecordBatch {
    let all = batch_of(columns);
    let columns = all.schema().fields().clone();
    let columns = columns.iter().zip(all.columns()).map(|(field, own)| {
        let array = if field.name() == name { array } else { own };
        (field.name().clone(), array.clone(), true)
    });
    RecordBatch::try_from_iter_with_nullable(columns).unwrap()
}

fn arrow_file(batch: &RecordBatch, packing: Option<CompressionType>) -> Vec<u8> {
    let options = IpcWriteOptions::default()
        .try_with_compression(packing)
        .unwrap();
    let mut file = FileWriter::try_new_with_options(Vec::new(), &batch.schema(), options).unwrap();
    // In two parts.
    let half = batch.num_rows() / 2;
    file.write(&batch.slice(0, half)).unwrap();
    file.write(&batch.slice(half, batch.num_rows() - half))
        .unwrap();
    file.finish().unwrap();
    file.into_inner().unwrap()
}

fn arrow_stream(batch: &RecordBatch) -> Vec<u8> {
    let mut stream = StreamWriter::try_new(Vec::new(), &batch.schema()).unwrap();
    stream.write(batch).unwrap();
    stream.finish().unwrap();
    stream.into_inner().unwrap()
}

/// Returns a Parquet file with a schema; `write` writes the columns of a group of rows.
fn parquet(schema: &str, packing: Compression, columns: &[Cells]) -> Vec<u8> {
    let schema = Arc::new(parse_message_type(&format!("message log {{ {schema} }}")).unwrap());
    let properties = WriterProperties::builder().set_compression(packing).build();
    let mut bytes = Vec::new();
    let mut file = SerializedFileWriter::new(&mut bytes, schema, Arc::new(properties)).unwrap();
    let mut group = file.next_row_group().unwrap();
    for cells in columns {
        let mut column = group.next_column().unwrap().unwrap();
        match cells {
            Cells::Reals(values) => {
                let levels: Vec<i16> = values.iter().map(|n| i16::from(!n.is_nan())).collect();
                let there: Vec<f64> = values.iter().copied().filter(|n| !n.is_nan()).collect();
                let typed = column.typed::<DoubleType>();
                typed.write_batch(&there, Some(&levels), None).unwrap();
            }
            Cells::Whole(values) => {
                let typed = column.typed::<Int64Type>();
                typed.write_batch(values, None, None).unwrap();
            }
            Cells::Texts(values) => {
                let texts: Vec<_> = values.iter().map(|text| text.as_str().into()).collect();
                let typed = column.typed::<ByteArrayType>();
                typed.write_batch(&texts, None, None).unwrap();
            }
        }
        column.close().unwrap();
    }
    group.close().unwrap();
    file.close().unwrap();
    bytes
}

/// Writes the values of a column of a Parquet file; NaN values of the first column are missing.
enum Cells {
    Reals(Vec<f64>),
    Whole(Vec<i64>),
    Texts(Vec<String>),
}

fn parquet_of(columns: &[Reals], packing: Compression) -> Vec<u8> {
    let schema = columns
        .iter()
        .map(|(name, _)| format!("optional double {name};"));
    let cells = columns
        .iter()
        .map(|(_, values)| Cells::Reals(values.clone()));
    let cells: Vec<Cells> = cells.collect();
    parquet(&schema.collect::<String>(), packing, &cells)
}

/// Returns a NumPy array with the given bytes.
fn npy(descr: &str, is_fortran: &str, shape: &str, numbers: &[u8]) -> Vec<u8> {
    let head =
        format!("{{'descr': '{descr}', 'fortran_order': {is_fortran}, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend(u16::try_from(head.len()).unwrap().to_le_bytes());
    bytes.extend(head.as_bytes());
    bytes.extend(numbers);
    bytes
}

fn npy_of(values: &[f64]) -> Vec<u8> {
    let numbers: Vec<u8> = values
        .iter()
        .flat_map(|number| number.to_le_bytes())
        .collect();
    npy("<f8", "False", &format!("({},)", values.len()), &numbers)
}

fn npz<'a>(
    packing: CompressionMethod,
    arrays: impl IntoIterator<Item = (&'a str, Vec<u8>)>,
) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(packing);
    for (name, array) in arrays {
        archive.start_file(format!("{name}.npy"), options).unwrap();
        archive.write_all(&array).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

fn npz_of(columns: &[Reals], packing: CompressionMethod) -> Vec<u8> {
    let arrays = columns
        .iter()
        .map(|(name, values)| (name.as_str(), npy_of(values)));
    npz(packing, arrays)
}

/// Returns the same columns in every kind of file.
fn every_kind(columns: &[Reals]) -> Vec<(&'static str, Vec<u8>)> {
    let zstd = Compression::ZSTD(ZstdLevel::default());
    let of_arrow = |packing| arrow_file(&batch_of(columns), packing);
    vec![
        ("Parquet", parquet_of(columns, Compression::UNCOMPRESSED)),
        ("Parquet, Snappy", parquet_of(columns, Compression::SNAPPY)),
        (
            "Parquet, gzip",
            parquet_of(columns, Compression::GZIP(Default::default())),
        ),
        ("Parquet, LZ4", parquet_of(columns, Compression::LZ4_RAW)),
        ("Parquet, Zstandard", parquet_of(columns, zstd)),
        ("Arrow", of_arrow(None)),
        ("Arrow, LZ4", of_arrow(Some(CompressionType::LZ4_FRAME))),
        ("Arrow, Zstandard", of_arrow(Some(CompressionType::ZSTD))),
        ("Arrow, stream", arrow_stream(&batch_of(columns))),
        ("npz", npz_of(columns, CompressionMethod::Stored)),
        ("npz, packed", npz_of(columns, CompressionMethod::Deflated)),
    ]
}

fn read_bytes(bytes: &[u8], options: &LogOptions) -> Log {
    let (folder, _) = in_folder();
    let path = folder.path().join("log.dat");
    fs::write(&path, bytes).unwrap();
    read(&path, options).unwrap()
}

fn refused_bytes(bytes: &[u8]) -> String {
    let (folder, _) = in_folder();
    let path = folder.path().join("log.dat");
    fs::write(&path, bytes).unwrap();
    refused(&path, &LogOptions::default())
}

#[test]
fn all_kinds_of_files_agree_with_text() {
    // Every other row lacks the force, as in a table that joins two rates.
    let joined = table(NAMES, |t, x| {
        let tick = (t * 25.0).round() as usize;
        match tick % 2 == 1 && tick + 1 < COUNT {
            true => plain(t, x).replace(",0,0,10", ",,,"),
            false => plain(t, x),
        }
    });
    let units = "time_ms,tcp_x_mm,tcp_y_mm,tcp_z_mm,qx,qy,qz,qw,fx_N,fy_N,fz_N";
    let in_units = table(units, |t, x| {
        let turn = format!("0,0,{},{}", 0.25_f64.sin(), 0.25_f64.cos());
        format!("{},{},0,800,{turn},0,0,10", 1e3 * t, 1e3 * x)
    });
    let renamed = table("when,x,y,z,qx,qy,qz,qw,fx,fy,fz", plain);
    let options = LogOptions {
        columns: vec![("t".to_owned(), "when".to_owned())],
        ..LogOptions::default()
    };
    for (text, options) in [
        (table(NAMES, plain), LogOptions::default()),
        (joined, LogOptions::default()),
        (in_units, LogOptions::default()),
        (renamed, options),
    ] {
        let expected = read_bytes(text.as_bytes(), &options);
        assert_is_it(&expected, "text");
        for (kind, bytes) in every_kind(&columns(&text)) {
            let log = read_bytes(&bytes, &options);
            assert_eq!(format!("{log:?}"), format!("{expected:?}"), "{kind}");
        }
    }
}

#[test]
fn dates_texts_and_other_numbers_are_read() {
    let columns = columns(&table(NAMES, plain));
    let in_arrow = |name: &str, array: ArrayRef| {
        let bytes = arrow_file(&batch_with(&columns, name, &array), None);
        let log = read_bytes(&bytes, &LogOptions::default());
        assert_is_it(&log, name);
        log
    };
    let zoned = TimestampNanosecondArray::from(dates()).with_timezone("UTC");
    let log = in_arrow("t", Arc::new(zoned));
    assert_eq!(log.start, dates()[0]);
    assert_eq!(log.remarks, [] as [&str; 0]);
    let durations = DurationNanosecondArray::from(dates());
    let log = in_arrow("t", Arc::new(durations));
    assert_eq!((log.start, log.remarks.len()), (dates()[0], 0));
    let log = in_arrow("t", Arc::new(TimestampNanosecondArray::from(dates())));
    assert_eq!(log.start, dates()[0]);
    assert!(log.remarks[0].contains("UTC"), "{:?}", log.remarks);
    in_arrow("fz", Arc::new(StringArray::from(vec!["10.0"; COUNT])));
    in_arrow("fz", Arc::new(Float32Array::from(vec![10.0; COUNT])));
    in_arrow("fz", Arc::new(Int8Array::from(vec![10; COUNT])));

    let others = columns[1..columns.len() - 1].iter();
    let schema = others
        .clone()
        .map(|(name, _)| format!("optional double {name};"));
    let schema = format!(
        "required int64 t (TIMESTAMP(NANOS,true)); {} required binary fz (STRING);",
        schema.collect::<String>()
    );
    let mut cells = vec![Cells::Whole(dates())];
    cells.extend(others.map(|(_, values)| Cells::Reals(values.clone())));
    cells.push(Cells::Texts(vec!["10".to_owned(); COUNT]));
    let bytes = parquet(&schema, Compression::SNAPPY, &cells);
    let log = read_bytes(&bytes, &LogOptions::default());
    assert_is_it(&log, "Parquet");
    assert_eq!((log.start, log.remarks.len()), (dates()[0], 0));

    let numbers: Vec<u8> = dates().iter().flat_map(|time| time.to_be_bytes()).collect();
    for kind in [">M8[ns]", ">m8[ns]", ">i8", ">u8"] {
        let mut arrays: Vec<(&str, Vec<u8>)> = vec![("t", npy(kind, "False", "(250,)", &numbers))];
        arrays.extend((columns[1..].iter()).map(|(name, values)| (name.as_str(), npy_of(values))));
        let tens = vec![10_u8; COUNT];
        *arrays.last_mut().unwrap() = ("fz", npy("|u1", "False", "(250,)", &tens));
        let log = read_bytes(
            &npz(CompressionMethod::Stored, arrays),
            &LogOptions::default(),
        );
        assert_is_it(&log, kind);
        assert_eq!(log.start, dates()[0], "{kind}");
    }
}

#[test]
fn arrays_of_many_numbers_per_row_are_columns() {
    let columns = columns(&table(NAMES, plain));
    let bytes = |number: &f64| number.to_le_bytes();
    let by_rows = (0..COUNT).flat_map(|row| columns[1..8].iter().map(move |column| column.1[row]));
    let by_rows: Vec<u8> = by_rows.flat_map(|number| bytes(&number)).collect();
    let by_columns = columns[8..].iter().flat_map(|column| &column.1);
    let by_columns: Vec<u8> = by_columns.flat_map(bytes).collect();
    let arrays = [
        ("t", npy_of(&columns[0].1)),
        ("pose", npy("<f8", "False", "(250, 7)", &by_rows)),
        ("force", npy("<f8", "True", "(250, 3)", &by_columns)),
        ("note", npy("|O", "False", "(1,)", b"pickled")),
    ];
    let theirs = [
        "pose_0", "pose_1", "pose_2", "pose_3", "pose_4", "pose_5", "pose_6",
    ];
    let theirs = theirs.iter().chain(&["force_0", "force_1", "force_2"]);
    let ours = NAMES.split(',').skip(1);
    let options = LogOptions {
        columns: (ours.zip(theirs))
            .map(|(ours, theirs)| (ours.to_owned(), (*theirs).to_owned()))
            .collect(),
        ..LogOptions::default()
    };
    let log = read_bytes(&npz(CompressionMethod::Deflated, arrays), &options);
    assert_is_it(&log, "arrays of rows");
}

#[test]
fn unsupported_contents_are_reported() {
    let columns = columns(&table(NAMES, plain));
    let flags: ArrayRef = Arc::new(BooleanArray::from(vec![true; COUNT]));
    let message = refused_bytes(&arrow_file(&batch_with(&columns, "fz", &flags), None));
    assert_eq!(
        message,
        ": column \"fz\" holds Boolean, but only numbers, times and text are read"
    );
    let lists = (0..COUNT).map(|_| Some([Some(1.0), Some(2.0)]));
    let lists: ArrayRef = Arc::new(ListArray::from_iter_primitive::<Float64Type, _, _>(lists));
    let message = refused_bytes(&arrow_stream(&batch_with(&columns, "fz", &lists)));
    assert!(
        message.starts_with(": unknown column \"fz\"")
            && message.ends_with("; lists, records and objects are not read: fz"),
        "{message}"
    );
    let mut arrays: Vec<(&str, Vec<u8>)> = Vec::new();
    arrays.extend(
        columns
            .iter()
            .map(|(name, values)| (name.as_str(), npy_of(values))),
    );
    *arrays.last_mut().unwrap() = ("fz", npy_of(&[1.0, 2.0]));
    let message = refused_bytes(&npz(CompressionMethod::Stored, arrays.clone()));
    assert_eq!(
        message,
        ": column \"t\" has 250 rows, but column \"fz\" has 2"
    );
    *arrays.last_mut().unwrap() = ("fz", npy("<f8", "False", "(250,)", &[0; 8]));
    let message = refused_bytes(&npz(CompressionMethod::Stored, arrays));
    assert_eq!(
        message,
        ": the npz file cannot be read: array \"fz\" has 8 bytes of numbers; expected 2000"
    );
    let message = refused_bytes(b"PK\x03\x04 and so on");
    assert!(
        message.starts_with(": the npz file cannot be read: "),
        "{message}"
    );
    assert_eq!(
        refused_bytes(b"FEA1 and so on"),
        ": the Arrow file cannot be read: version 1 of Feather is not read; write version 2"
    );
}

#[test]
fn too_long_data_is_refused_before_unpacking() {
    const MANY: usize = 5_000_001;
    let rows = ": the table has 5000001 rows, and the limit is 5000000";
    let cells = [Cells::Whole(vec![0; MANY])];
    let bytes = parquet("required int64 t;", Compression::SNAPPY, &cells);
    assert_eq!(refused_bytes(&bytes), rows);
    let zeros: ArrayRef = Arc::new(Int8Array::from(vec![0; MANY]));
    let arrays = NAMES.split(',').map(|name| (name, zeros.clone()));
    let batch = RecordBatch::try_from_iter(arrays).unwrap();
    let bytes = arrow_file(&batch, Some(CompressionType::LZ4_FRAME));
    assert_eq!(refused_bytes(&bytes), rows);
    let of_shape = |shape: &str| {
        let arrays = NAMES.split(',').map(|name| {
            let shape = if name == "t" { shape } else { "(250,)" };
            (name, npy("<f8", "False", shape, &[]))
        });
        npz(CompressionMethod::Stored, arrays)
    };
    assert_eq!(refused_bytes(&of_shape("(5000001,)")), rows);

    // Each column claims a length of a terabyte.
    let columns = columns(&table(NAMES, plain));
    let mut bytes = arrow_file(&batch_of(&columns), Some(CompressionType::ZSTD));
    let length = (COUNT as u64 / 2 * 8).to_le_bytes();
    let places: Vec<usize> = (0..bytes.len() - 8)
        .filter(|&k| bytes[k..k + 8] == length)
        .collect();
    assert!(!places.is_empty());
    for place in places {
        bytes[place..place + 8].copy_from_slice(&(1_u64 << 40).to_le_bytes());
    }
    let message = refused_bytes(&bytes);
    assert!(
        message.starts_with(": a batch of rows is ")
            && message.ends_with(" bytes long when unpacked, and the limit is 1073741824 bytes"),
        "{message}"
    );
}

static SMALL: LazyLock<Vec<(&str, Vec<u8>)>> =
    LazyLock::new(|| every_kind(&columns(&table(NAMES, plain))));

#[test]
fn a_file_that_is_cut_off_is_an_error() {
    for (kind, bytes) in &*SMALL {
        for share in [0.1, 0.3, 0.5, 0.7, 0.9, 0.99] {
            let message = refused_bytes(&bytes[..(bytes.len() as f64 * share) as usize]);
            let name = kind.split(',').next().unwrap();
            assert!(
                message.starts_with(&format!(": the {name} file cannot be read: ")),
                "{kind} {share}: {message}"
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    /// Any damage gives a log or an error, never a panic.
    #[test]
    fn damaged_tables_cause_no_panic(
        which in any::<prop::sample::Index>(),
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        at_end: bool,
    ) {
        let mut bytes = SMALL[which.index(SMALL.len())].1.clone();
        for (index, byte) in damage {
            // The positions of all other data are at the end of the file.
            let last = bytes.len().min(if at_end { 1000 } else { usize::MAX });
            let index = bytes.len() - 1 - index.index(last);
            bytes[index] = byte;
        }
        let (folder, _) = in_folder();
        let path = folder.path().join("log.dat");
        fs::write(&path, bytes).unwrap();
        match read(&path, &LogOptions::default()) {
            Ok(log) => prop_assert!(!log.samples.is_empty()),
            Err(error) => prop_assert!(!matches!(error.fault, ReadFault::System(_))),
        }
    }
}
