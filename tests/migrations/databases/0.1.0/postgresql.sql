--
-- PostgreSQL database dump
--

\restrict bxndQLSEP72JbX5cuKvcelqfT5qDmwbbzTxzXBP91xx9T58AChnJYaIT4cMtGsQ

-- Dumped from database version 18.6
-- Dumped by pg_dump version 18.6

SET statement_timeout = 0;
SET lock_timeout = 0;
SET idle_in_transaction_session_timeout = 0;
SET transaction_timeout = 0;
SET client_encoding = 'UTF8';
SET standard_conforming_strings = on;
SELECT pg_catalog.set_config('search_path', '', false);
SET check_function_bodies = false;
SET xmloption = content;
SET client_min_messages = warning;
SET row_security = off;

SET default_tablespace = '';

SET default_table_access_method = heap;

--
-- Name: alembic_version; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.alembic_version (
    version_num character varying(32) NOT NULL
);


--
-- Name: case; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public."case" (
    id bigint NOT NULL,
    digest character varying(64) NOT NULL,
    solver_version character varying NOT NULL,
    operator_key character varying(64) NOT NULL,
    inputs json NOT NULL,
    speed_kmh double precision NOT NULL,
    slab character varying NOT NULL,
    irregularity character varying NOT NULL,
    spectrum character varying,
    percentile double precision,
    wavelength_min_m double precision,
    wavelength_max_m double precision,
    seed bigint,
    realisation integer,
    wavelength_m double precision,
    amplitude_mm double precision,
    state character varying(16) NOT NULL,
    priority integer NOT NULL,
    attempt integer NOT NULL,
    lease_token character varying(32),
    lease_expires double precision,
    heartbeat_at double precision,
    worker character varying,
    progress double precision NOT NULL,
    error json,
    cpu_s double precision,
    created_at double precision NOT NULL,
    started_at double precision,
    finished_at double precision,
    CONSTRAINT ck_case_state CHECK (((state)::text = ANY ((ARRAY['queued'::character varying, 'running'::character varying, 'succeeded'::character varying, 'failed'::character varying, 'cancelled'::character varying])::text[])))
);


--
-- Name: case_id_seq; Type: SEQUENCE; Schema: public; Owner: -
--

CREATE SEQUENCE public.case_id_seq
    START WITH 1
    INCREMENT BY 1
    NO MINVALUE
    NO MAXVALUE
    CACHE 1;


--
-- Name: case_id_seq; Type: SEQUENCE OWNED BY; Schema: public; Owner: -
--

ALTER SEQUENCE public.case_id_seq OWNED BY public."case".id;


--
-- Name: event; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.event (
    id bigint NOT NULL,
    study_id character varying(32) NOT NULL,
    kind character varying(16) NOT NULL,
    payload json NOT NULL,
    created_at double precision NOT NULL
);


--
-- Name: event_id_seq; Type: SEQUENCE; Schema: public; Owner: -
--

CREATE SEQUENCE public.event_id_seq
    START WITH 1
    INCREMENT BY 1
    NO MINVALUE
    NO MAXVALUE
    CACHE 1;


--
-- Name: event_id_seq; Type: SEQUENCE OWNED BY; Schema: public; Owner: -
--

ALTER SEQUENCE public.event_id_seq OWNED BY public.event.id;


--
-- Name: history; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.history (
    case_id bigint NOT NULL,
    key character varying NOT NULL,
    digest character varying(64) NOT NULL,
    size_bytes bigint NOT NULL
);


--
-- Name: idempotency_key; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.idempotency_key (
    key character varying(255) NOT NULL,
    request_digest character varying(64) NOT NULL,
    response json NOT NULL,
    created_at double precision NOT NULL
);


--
-- Name: peak; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.peak (
    id bigint NOT NULL,
    case_id bigint NOT NULL,
    quantity character varying NOT NULL,
    "position" character varying NOT NULL,
    unit character varying NOT NULL,
    peak double precision NOT NULL,
    maximum double precision NOT NULL,
    minimum double precision NOT NULL,
    mean double precision NOT NULL,
    std double precision NOT NULL,
    rms double precision NOT NULL,
    time_s double precision NOT NULL,
    track_position_m double precision NOT NULL
);


--
-- Name: peak_id_seq; Type: SEQUENCE; Schema: public; Owner: -
--

CREATE SEQUENCE public.peak_id_seq
    START WITH 1
    INCREMENT BY 1
    NO MINVALUE
    NO MAXVALUE
    CACHE 1;


--
-- Name: peak_id_seq; Type: SEQUENCE OWNED BY; Schema: public; Owner: -
--

ALTER SEQUENCE public.peak_id_seq OWNED BY public.peak.id;


--
-- Name: study; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.study (
    id character varying(32) NOT NULL,
    name character varying NOT NULL,
    labels json NOT NULL,
    priority integer NOT NULL,
    keep_history boolean NOT NULL,
    request json NOT NULL,
    cases_reused integer NOT NULL,
    created_at double precision NOT NULL,
    started_at double precision,
    finished_at double precision,
    cancel_requested_at double precision
);


--
-- Name: study_case; Type: TABLE; Schema: public; Owner: -
--

CREATE TABLE public.study_case (
    study_id character varying(32) NOT NULL,
    case_id bigint NOT NULL,
    "position" integer NOT NULL
);


--
-- Name: case id; Type: DEFAULT; Schema: public; Owner: -
--

ALTER TABLE ONLY public."case" ALTER COLUMN id SET DEFAULT nextval('public.case_id_seq'::regclass);


--
-- Name: event id; Type: DEFAULT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.event ALTER COLUMN id SET DEFAULT nextval('public.event_id_seq'::regclass);


--
-- Name: peak id; Type: DEFAULT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.peak ALTER COLUMN id SET DEFAULT nextval('public.peak_id_seq'::regclass);


--
-- Data for Name: alembic_version; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.alembic_version VALUES ('0001');


--
-- Data for Name: case; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public."case" VALUES (1, '3d97b198e43bb981a1f36aa43f76c6070bfee4954903a41a81408e2aa6a78e72', '1', '5ec189555287046096fe894b49144171dfecc303d49133e75843a894ab36daaf', '{"speed": 83.33333333333333, "slab": "continuous", "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 50000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0}}', 300, 'continuous', 'harmonic', NULL, NULL, NULL, NULL, NULL, NULL, 1, 0.3, 'succeeded', 0, 1, NULL, NULL, 1795340216.981, 'host:18674', 1, NULL, 2.344505657999999, 1795340190.635, 1795340214.405, 1795340217.39);
INSERT INTO public."case" VALUES (2, '499e08b74be1f02ee62c0e8e3ae741088e14d59ca283572db2d333c5637c4e0c', '1', '7ac4b90e8f7bcdc656f8d35be99f4119c03c8bf74cf53aa525f9af1bd0ed0bf2', '{"speed": 83.33333333333333, "slab": "discontinuous", "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 50000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0}}', 300, 'discontinuous', 'harmonic', NULL, NULL, NULL, NULL, NULL, NULL, 1, 0.3, 'succeeded', 0, 1, NULL, NULL, 1795340219.832, 'host:18674', 1, NULL, 2.143658519999999, 1795340190.635, 1795340217.468, 1795340220.17);
INSERT INTO public."case" VALUES (3, 'afff6f7819ded79cd33ca12e051208c5d1279656ee963780a87553aaa05fcf9c', '1', '3b5551389ff7abe220a91a258ba910869bdeb36008056a93aefa3e0ea232af83', '{"speed": 69.44444444444444, "slab": "continuous", "irregularity": {"kind": "spectrum", "wavelength_min": 2.0, "wavelength_max": 30.0, "spectrum": "tb3352-ballastless", "percentile": 25.0, "seed": 7, "realisation": 0}, "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 60000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0}}', 250, 'continuous', 'spectrum', 'tb3352-ballastless', 25, 2, 30, 7, 0, NULL, NULL, 'succeeded', 0, 1, NULL, NULL, 1795340221.144, 'host:18674', 1, NULL, 0.7999163229999979, 1795340220.299, 1795340220.331, 1795340221.501);
INSERT INTO public."case" VALUES (4, '1b89d0e3a99e55271ac21a6824c6feedd2309d4f04181c1573c0f71d7c3e061f', '1', '4cc52d326b7dbb6f60f2c6791c9f17fe73777fa6e22adbdc09529b9c6a3c5f27', '{"speed": 55.55555555555556, "slab": "continuous", "irregularity": {"kind": "harmonic", "wavelength": 1.0, "amplitude": 0.0003}, "track": {"rail_elastic_modulus": 205900000000.0, "rail_second_moment": 3.217e-05, "rail_mass": 60.64, "pad_stiffness": 60000000.0, "pad_damping": 47700.0, "pad_spacing": 0.65, "slab_elastic_modulus": 39000000000.0, "slab_second_moment": 0.0008500000000000002, "slab_mass": 637.5, "mortar_stiffness": 900000000.0, "mortar_damping": 83000.0, "base_elastic_modulus": 30000000000.0, "base_second_moment": 0.00331875, "base_mass": 1106.25, "roadbed_stiffness": 60000000.0, "roadbed_damping": 90000.0, "joint": {"shear_stiffness": 100000000.0, "shear_damping": 80000.0, "pads_per_slab": 10, "position": 0.5}}, "vehicle": {"car_body_mass": 40000.0, "car_body_pitch_inertia": 547000.0, "bogie_mass": 3200.0, "bogie_pitch_inertia": 6800.0, "wheelset_mass": 2400.0, "primary_stiffness": 2080000.0, "primary_damping": 100000.0, "secondary_stiffness": 800000.0, "secondary_damping": 120000.0, "half_bogie_distance": 8.6875, "half_wheelbase": 1.25, "wheel_radius": 0.43, "wheel_tread": "worn"}, "numerics": {"track_length": 90.0, "elements_per_pad": 4, "mesh_offset": 0.5, "time_step": 0.0001, "start": 0.0, "settle": 0.3, "window": 0.2, "ease_in": 0.2, "spectral_radius": 0.8, "absorbing_length": 24.0, "absorbing_damping": 3000000.0}}', 200, 'continuous', 'harmonic', NULL, NULL, NULL, NULL, NULL, NULL, 1, 0.3, 'queued', 0, 0, NULL, NULL, NULL, NULL, 0, NULL, NULL, 1795340236.466, NULL, NULL);


--
-- Data for Name: event; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.event VALUES (1, '6807b42aa19a44e280ad3dfcaeb28fc2', 'state', '{"state": "queued"}', 1795340190.651);
INSERT INTO public.event VALUES (2, '6807b42aa19a44e280ad3dfcaeb28fc2', 'state', '{"state": "running"}', 1795340214.419);
INSERT INTO public.event VALUES (3, '6807b42aa19a44e280ad3dfcaeb28fc2', 'case', '{"case_id": 1, "state": "succeeded"}', 1795340217.455);
INSERT INTO public.event VALUES (4, '6807b42aa19a44e280ad3dfcaeb28fc2', 'case', '{"case_id": 2, "state": "succeeded"}', 1795340220.194);
INSERT INTO public.event VALUES (5, '6807b42aa19a44e280ad3dfcaeb28fc2', 'state', '{"state": "succeeded"}', 1795340220.221);
INSERT INTO public.event VALUES (6, '6807b42aa19a44e280ad3dfcaeb28fc2', 'done', '{"state": "succeeded"}', 1795340220.223);
INSERT INTO public.event VALUES (7, '879c27dd374647edbf3ff89ad636c339', 'state', '{"state": "queued"}', 1795340220.302);
INSERT INTO public.event VALUES (8, '879c27dd374647edbf3ff89ad636c339', 'state', '{"state": "running"}', 1795340220.335);
INSERT INTO public.event VALUES (9, '879c27dd374647edbf3ff89ad636c339', 'case', '{"case_id": 3, "state": "succeeded"}', 1795340221.528);
INSERT INTO public.event VALUES (10, '879c27dd374647edbf3ff89ad636c339', 'state', '{"state": "succeeded"}', 1795340221.54);
INSERT INTO public.event VALUES (11, '879c27dd374647edbf3ff89ad636c339', 'done', '{"state": "succeeded"}', 1795340221.541);
INSERT INTO public.event VALUES (12, 'c6d81aba110d4ac9a86c3ae993d2f911', 'state', '{"state": "queued"}', 1795340236.473);


--
-- Data for Name: history; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.history VALUES (1, '3d97b198e43bb981a1f36aa43f76c6070bfee4954903a41a81408e2aa6a78e72/1-6189e79e6d5a4bdf82ea2ec2948149e2.npz', 'f5935bb496f01f5c59f1dd881f58c639d5dcf3415eea12bff118f9625b234397', 142573);
INSERT INTO public.history VALUES (2, '499e08b74be1f02ee62c0e8e3ae741088e14d59ca283572db2d333c5637c4e0c/1-cb8a3bd7c36f468486c0e31d69d22a2d.npz', 'ec12cdc81e4275a7c6f98a8cfdf1911209704180f426227e7e0335b57bee1bc4', 165836);


--
-- Data for Name: idempotency_key; Type: TABLE DATA; Schema: public; Owner: -
--



--
-- Data for Name: peak; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.peak VALUES (1, 1, 'wheel_rail_force', 'wheelset_1', 'N', 111478.58673975886, 111478.58673975886, 26532.37383710361, 68496.52493317945, 29706.451566972988, 74660.88127408212, 0.12760000000000002, 35.63333333333333);
INSERT INTO public.peak VALUES (2, 1, 'wheel_rail_force', 'wheelset_2', 'N', 109949.95381841973, 109949.95381841973, 28166.787163722813, 68841.49347644461, 28607.88498017995, 74549.05973321575, 0.025500000000000002, 27.125);
INSERT INTO public.peak VALUES (3, 1, 'wheel_rail_force', 'wheelset_3', 'N', 103982.60922724742, 103982.60922724742, 33963.634484533606, 68351.99899741924, 24351.26453712435, 72560.18089489723, 0.1799, 39.99166666666667);
INSERT INTO public.peak VALUES (4, 1, 'wheel_rail_force', 'wheelset_4', 'N', 101782.13210927692, 101782.13210927692, 36165.591763048695, 68937.46852665645, 22839.415857681834, 72622.40345502122, 0.078, 31.5);
INSERT INTO public.peak VALUES (5, 1, 'rail_displacement', 'wheelset_1', 'm', 0.0013610144888988754, 0.0013610144888988754, 0.0006165102632856585, 0.0009832675858631114, 0.00026185341482239284, 0.001017537397967868, 0.0806, 31.716666666666665);
INSERT INTO public.peak VALUES (6, 1, 'rail_acceleration', 'wheelset_1', 'm/s^2', 131.8632503025223, 98.55378552793468, -131.8632503025223, -12.759288904971983, 79.32964489422456, 80.3491880009021, 0.1285, 35.708333333333336);
INSERT INTO public.peak VALUES (7, 1, 'rail_acceleration_moving_frame', 'wheelset_1', 'm/s^2', 103.80575555838897, 101.49479679413986, -103.80575555838897, 1.215437914486277, 71.84243383763715, 71.8527145558137, 0.1285, 35.708333333333336);
INSERT INTO public.peak VALUES (8, 1, 'slab_displacement', 'wheelset_1', 'm', 0.00048442086691422145, 0.00048442086691422145, 0.00039184559166548287, 0.0004382864460307028, 3.2123647895201055e-05, 0.00043946210021834523, 0.132, 36);
INSERT INTO public.peak VALUES (9, 1, 'slab_acceleration', 'wheelset_1', 'm/s^2', 13.953629782445518, 12.399309743407485, -13.953629782445518, -0.691646674792865, 9.06778576733884, 9.094125238037183, 0.048100000000000004, 29.008333333333333);
INSERT INTO public.peak VALUES (10, 1, 'base_displacement', 'wheelset_1', 'm', 0.0004641644289366487, 0.0004641644289366487, 0.0003410776447640088, 0.0004022495209651519, 4.326257711238919e-05, 0.00040456931136098254, 0.1086, 34.05);
INSERT INTO public.peak VALUES (11, 1, 'base_acceleration', 'wheelset_1', 'm/s^2', 18.17188148733422, 17.717341749405595, -18.17188148733422, -0.4621650408937784, 12.541438293797206, 12.549951035846608, 0.1447, 37.05833333333334);
INSERT INTO public.peak VALUES (12, 1, 'car_body_acceleration', 'car_body', 'm/s^2', 0.001368924973377261, 0.0011400280719442433, -0.001368924973377261, 1.151611406235986e-05, 0.0007863782922941898, 0.000786462611619029, 0.0753, 31.275);
INSERT INTO public.peak VALUES (13, 1, 'bogie_acceleration', 'bogie_1', 'm/s^2', 0.12089434053841328, 0.12089434053841328, -0.10239915915200014, 0.0011513692073500384, 0.061137062603859586, 0.06114790327460035, 0.125, 35.41666666666667);
INSERT INTO public.peak VALUES (14, 1, 'bogie_acceleration', 'bogie_2', 'm/s^2', 0.19436792575433512, 0.16228351812364036, -0.19436792575433512, -0.0003737901037442777, 0.10639653675075729, 0.10639719334454695, 0.049, 29.083333333333336);
INSERT INTO public.peak VALUES (15, 1, 'wheelset_acceleration', 'wheelset_1', 'm/s^2', 35.42276834331281, 34.845335223126526, -35.42276834331281, 0.09920902471669087, 24.589742136887363, 24.589942268927743, 0.1274, 35.61666666666667);
INSERT INTO public.peak VALUES (16, 1, 'wheelset_acceleration', 'wheelset_2', 'm/s^2', 34.16212808336587, 33.521299649833054, -34.16212808336587, -0.09932131557742975, 23.682892920098425, 23.683101186047747, 0.025400000000000002, 27.116666666666667);
INSERT INTO public.peak VALUES (17, 1, 'wheelset_acceleration', 'wheelset_3', 'm/s^2', 29.201597420319345, 28.71842628127553, -29.201597420319345, 0.2931876797693455, 20.138583661615595, 20.14071773575756, 0.0477, 28.974999999999998);
INSERT INTO public.peak VALUES (18, 1, 'wheelset_acceleration', 'wheelset_4', 'm/s^2', 27.403819346309174, 26.900542096028495, -27.403819346309174, -0.25054272959991236, 18.890520889746572, 18.892182275886157, 0.0779, 31.491666666666667);
INSERT INTO public.peak VALUES (19, 1, 'wheel_rail_force_20hz', 'wheelset_1', 'N', 108810.69061939006, 108810.69061939006, 39025.53554765359, 68960.18769041616, 7494.994337947457, 69366.29171595733, 0.2, 41.666666666666664);
INSERT INTO public.peak VALUES (20, 1, 'wheel_unloading', 'wheelset_1', '1', 0.6136249623255627, 0.6136249623255627, -0.6233957585518983, 0.0025262132928579265, 0.43259722683810964, 0.43260460286689495, 0.1096, 34.13333333333333);
INSERT INTO public.peak VALUES (21, 1, 'contact_loss', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (22, 1, 'wheel_rail_force_20hz', 'wheelset_2', 'N', 97752.36880619061, 97752.36880619061, 29805.394736599384, 68397.50714678234, 7290.975934216819, 68785.00791573315, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (23, 1, 'wheel_unloading', 'wheelset_2', '1', 0.5898239818884111, 0.5898239818884111, -0.601135194676274, -0.002497356581397895, 0.4165994609025768, 0.4166069461905458, 0.1395, 36.625);
INSERT INTO public.peak VALUES (24, 1, 'contact_loss', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (25, 1, 'wheel_rail_force_20hz', 'wheelset_3', 'N', 103420.63726179006, 103420.63726179006, 52560.76472473741, 69111.58923577836, 5724.155690780393, 69348.23519792878, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (26, 1, 'wheel_unloading', 'wheelset_3', '1', 0.5054079731391641, 0.5054079731391641, -0.5142363364969771, 0.0046308577629352605, 0.3546128518585168, 0.35464308754979407, 0.16190000000000002, 38.49166666666667);
INSERT INTO public.peak VALUES (27, 1, 'contact_loss', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (28, 1, 'wheel_rail_force_20hz', 'wheelset_4', 'N', 84683.27772880957, 84683.27772880957, 37139.56119245749, 68304.17054347739, 5285.899262268056, 68508.39689150002, 0.2, 41.666666666666664);
INSERT INTO public.peak VALUES (29, 1, 'wheel_unloading', 'wheelset_4', '1', 0.4733421907230422, 0.4733421907230422, -0.48219210877059737, -0.003894983641422133, 0.3325967068251323, 0.33261951278974894, 0.1681, 39.00833333333333);
INSERT INTO public.peak VALUES (30, 1, 'contact_loss', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (31, 1, 'car_body_acceleration_comfort', 'car_body', 'm/s^2', 0.0009047486841868258, -4.1950253610493706e-05, -0.0009047486841868258, -0.0005774274157812326, 0.00020385401055425146, 0.0006123551895059315, 0.15610000000000002, 38.00833333333333);
INSERT INTO public.peak VALUES (32, 1, 'wheel_rail_force_quantile', 'wheelset_1', 'N', 111407.6736028007, 111407.6736028007, 111407.6736028007, 111407.6736028007, 0, 111407.6736028007, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (33, 1, 'wheel_rail_force_20hz_quantile', 'wheelset_1', 'N', 107811.87437747214, 107811.87437747214, 107811.87437747214, 107811.87437747214, 0, 107811.87437747214, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (34, 1, 'contact_loss_events', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (35, 1, 'contact_loss_duration', 'wheelset_1', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (36, 1, 'wheel_rail_force_quantile', 'wheelset_2', 'N', 109924.36565409557, 109924.36565409557, 109924.36565409557, 109924.36565409557, 0, 109924.36565409557, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (37, 1, 'wheel_rail_force_20hz_quantile', 'wheelset_2', 'N', 96994.1458106413, 96994.1458106413, 96994.1458106413, 96994.1458106413, 0, 96994.1458106413, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (38, 1, 'contact_loss_events', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (39, 1, 'contact_loss_duration', 'wheelset_2', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (40, 1, 'wheel_rail_force_quantile', 'wheelset_3', 'N', 103951.20980465332, 103951.20980465332, 103951.20980465332, 103951.20980465332, 0, 103951.20980465332, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (41, 1, 'wheel_rail_force_20hz_quantile', 'wheelset_3', 'N', 102529.6725572027, 102529.6725572027, 102529.6725572027, 102529.6725572027, 0, 102529.6725572027, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (42, 1, 'contact_loss_events', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (43, 1, 'contact_loss_duration', 'wheelset_3', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (44, 1, 'wheel_rail_force_quantile', 'wheelset_4', 'N', 101737.18670565152, 101737.18670565152, 101737.18670565152, 101737.18670565152, 0, 101737.18670565152, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (45, 1, 'wheel_rail_force_20hz_quantile', 'wheelset_4', 'N', 84284.90536687603, 84284.90536687603, 84284.90536687603, 84284.90536687603, 0, 84284.90536687603, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (46, 1, 'contact_loss_events', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (47, 1, 'contact_loss_duration', 'wheelset_4', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (48, 1, 'sperling_index', 'car_body', '1', 0.23345456286820498, 0.23345456286820498, 0.23345456286820498, 0.23345456286820498, 0, 0.23345456286820498, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (49, 2, 'wheel_rail_force', 'wheelset_1', 'N', 110654.82134115638, 110654.82134115638, 27121.486186165093, 68504.61238393755, 29094.27813893228, 74426.86973330991, 0.12760000000000002, 35.63333333333333);
INSERT INTO public.peak VALUES (50, 2, 'wheel_rail_force', 'wheelset_2', 'N', 109555.04010307233, 109555.04010307233, 28050.309453718397, 68846.16262467338, 28247.72560717199, 74415.91301678057, 0.0016, 25.133333333333336);
INSERT INTO public.peak VALUES (51, 2, 'wheel_rail_force', 'wheelset_3', 'N', 104693.64226945036, 104693.64226945036, 33082.78969805083, 68325.31460186215, 24701.55024223611, 72653.39083493043, 0.1559, 37.99166666666667);
INSERT INTO public.peak VALUES (52, 2, 'wheel_rail_force', 'wheelset_4', 'N', 102284.97910126572, 102284.97910126572, 36008.300264998135, 68959.87083146388, 22880.370789028322, 72656.5561565892, 0.1018, 33.483333333333334);
INSERT INTO public.peak VALUES (53, 2, 'rail_displacement', 'wheelset_1', 'm', 0.0013595662108105042, 0.0013595662108105042, 0.0006134827469090712, 0.0009830414767581022, 0.0002608491164119613, 0.0010170608666936565, 0.0806, 31.716666666666665);
INSERT INTO public.peak VALUES (54, 2, 'rail_acceleration', 'wheelset_1', 'm/s^2', 131.7610577837875, 99.52823400532684, -131.7610577837875, -12.754247371728113, 79.5446705913794, 80.56069417222206, 0.1285, 35.708333333333336);
INSERT INTO public.peak VALUES (55, 2, 'rail_acceleration_moving_frame', 'wheelset_1', 'm/s^2', 103.59633077953059, 101.75541430220632, -103.59633077953059, 1.2100466979123516, 71.57923783083824, 71.58946501724142, 0.044700000000000004, 28.724999999999998);
INSERT INTO public.peak VALUES (56, 2, 'slab_displacement', 'wheelset_1', 'm', 0.0004859596037434481, 0.0004859596037434481, 0.0003908742817200574, 0.0004379981528233641, 3.112587903377795e-05, 0.0004391027239978185, 0.1557, 37.975);
INSERT INTO public.peak VALUES (57, 2, 'slab_acceleration', 'wheelset_1', 'm/s^2', 15.556075600091189, 13.510145285547143, -15.556075600091189, -0.658282313517147, 8.80729106663534, 8.8318577624826, 0.047900000000000005, 28.991666666666667);
INSERT INTO public.peak VALUES (58, 2, 'base_displacement', 'wheelset_1', 'm', 0.0004629592213766134, 0.0004629592213766134, 0.00034139450407339307, 0.0004019429927359105, 4.072935158423433e-05, 0.00040400129887164024, 0.1564, 38.03333333333333);
INSERT INTO public.peak VALUES (59, 2, 'base_acceleration', 'wheelset_1', 'm/s^2', 18.042240914775647, 16.978151198383568, -18.042240914775647, -0.42640727152939106, 11.536669923371962, 11.544547461119834, 0.12040000000000001, 35.03333333333333);
INSERT INTO public.peak VALUES (60, 2, 'car_body_acceleration', 'car_body', 'm/s^2', 0.0016495305121821955, 0.0016495305121821955, -0.00136843936182629, -1.163856311325874e-05, 0.0007826149168034702, 0.0007827014527612963, 0.18960000000000002, 40.8);
INSERT INTO public.peak VALUES (61, 2, 'bogie_acceleration', 'bogie_1', 'm/s^2', 0.12302011134779353, 0.12302011134779353, -0.10821383913950376, 0.0006265077861500316, 0.04975716610436757, 0.04976111022418744, 0.101, 33.416666666666664);
INSERT INTO public.peak VALUES (62, 2, 'bogie_acceleration', 'bogie_2', 'm/s^2', 0.23060458842483195, 0.21559659457714983, -0.23060458842483195, -0.0014603477062613565, 0.11562224786569479, 0.11563146983818613, 0.1577, 38.141666666666666);
INSERT INTO public.peak VALUES (63, 2, 'wheelset_acceleration', 'wheelset_1', 'm/s^2', 34.72705562546345, 34.34621812961569, -34.72705562546345, 0.0939326014594426, 24.08325309880902, 24.08343628211953, 0.1274, 35.61666666666667);
INSERT INTO public.peak VALUES (64, 2, 'wheelset_acceleration', 'wheelset_2', 'm/s^2', 33.815846434354434, 33.576216928783964, -33.815846434354434, -0.10378883811838785, 23.38461014110697, 23.384840465020943, 0.0014, 25.116666666666664);
INSERT INTO public.peak VALUES (65, 2, 'wheelset_acceleration', 'wheelset_3', 'm/s^2', 29.80662088758294, 29.413397458772327, -29.80662088758294, 0.31549437990341433, 20.42802038293572, 20.430456516421454, 0.0716, 30.96666666666667);
INSERT INTO public.peak VALUES (66, 2, 'wheelset_acceleration', 'wheelset_4', 'm/s^2', 27.878892612262156, 27.026677068315784, -27.878892612262156, -0.267633114339469, 18.924791671513823, 18.926684001538412, 0.1017, 33.475);
INSERT INTO public.peak VALUES (67, 2, 'joint_opening', 'joints', 'm', 4.6582989985384525e-05, 4.3624755163630156e-05, -4.6582989985384525e-05, 8.529974813274391e-07, 2.2690428551114146e-05, 2.270645618621204e-05, 0.1348, 36.233333333333334);
INSERT INTO public.peak VALUES (68, 2, 'joint_slope_jump', 'joints', 'rad', 0.00023172056077080868, 0.00021972739369301807, -0.00023172056077080868, 2.750242899642567e-06, 0.00012716388620000592, 0.0001271936232265403, 0.14780000000000001, 37.31666666666667);
INSERT INTO public.peak VALUES (69, 2, 'joint_shear', 'joints', 'N', 5076.614883354255, 4584.708972086482, -5076.614883354255, 46.22742936769612, 2431.7483117158704, 2432.1876627347096, 0.1342, 36.18333333333334);
INSERT INTO public.peak VALUES (70, 2, 'wheel_rail_force_20hz', 'wheelset_1', 'N', 108398.16841306227, 108398.16841306227, 39709.78726150317, 68965.45820516547, 7385.963593991634, 69359.83624303187, 0.2, 41.666666666666664);
INSERT INTO public.peak VALUES (71, 2, 'wheel_unloading', 'wheelset_1', '1', 0.6050460727222209, 0.6050460727222209, -0.6113997574072576, 0.0024084406008801976, 0.4236825125809273, 0.42368935796526164, 0.08560000000000001, 32.13333333333333);
INSERT INTO public.peak VALUES (72, 2, 'contact_loss', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (73, 2, 'wheel_rail_force_20hz', 'wheelset_2', 'N', 97096.05120802288, 97096.05120802288, 29688.270421222733, 68377.02483496851, 7247.93524036034, 68760.0908269496, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (74, 2, 'wheel_unloading', 'wheelset_2', '1', 0.5915201768790098, 0.5915201768790098, -0.5953843032339061, -0.0025653505850207143, 0.4113546760910439, 0.4113626752217461, 0.11560000000000001, 34.63333333333333);
INSERT INTO public.peak VALUES (75, 2, 'contact_loss', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (76, 2, 'wheel_rail_force_20hz', 'wheelset_3', 'N', 104143.39307433498, 104143.39307433498, 53201.20609747465, 69134.41583976352, 5781.203794938833, 69375.71456081704, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (77, 2, 'wheel_unloading', 'wheelset_3', '1', 0.5182351871552231, 0.5182351871552231, -0.5245906839879184, 0.005019446601687088, 0.35971385236982834, 0.359748871340731, 0.18580000000000002, 40.483333333333334);
INSERT INTO public.peak VALUES (78, 2, 'contact_loss', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (79, 2, 'wheel_rail_force_20hz', 'wheelset_4', 'N', 83817.30023418981, 83817.30023418981, 37158.02368629386, 68289.87996537202, 5227.086936232799, 68489.635299977, 0.2, 41.666666666666664);
INSERT INTO public.peak VALUES (80, 2, 'wheel_unloading', 'wheelset_4', '1', 0.4756327324159293, 0.4756327324159293, -0.48951476774815383, -0.004221214962339633, 0.3331931089126012, 0.3332198470718735, 0.14400000000000002, 37);
INSERT INTO public.peak VALUES (81, 2, 'contact_loss', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (82, 2, 'car_body_acceleration_comfort', 'car_body', 'm/s^2', 0.0011617703753085376, 2.2066930689313487e-05, -0.0011617703753085376, -0.0009145621511496859, 0.00023543462089093667, 0.0009443798965615481, 0.0485, 29.041666666666668);
INSERT INTO public.peak VALUES (83, 2, 'wheel_rail_force_quantile', 'wheelset_1', 'N', 110495.80746114842, 110495.80746114842, 110495.80746114842, 110495.80746114842, 0, 110495.80746114842, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (84, 2, 'wheel_rail_force_20hz_quantile', 'wheelset_1', 'N', 107409.62849549284, 107409.62849549284, 107409.62849549284, 107409.62849549284, 0, 107409.62849549284, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (85, 2, 'contact_loss_events', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (86, 2, 'contact_loss_duration', 'wheelset_1', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (87, 2, 'wheel_rail_force_quantile', 'wheelset_2', 'N', 109541.57374804454, 109541.57374804454, 109541.57374804454, 109541.57374804454, 0, 109541.57374804454, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (88, 2, 'wheel_rail_force_20hz_quantile', 'wheelset_2', 'N', 96354.6985373394, 96354.6985373394, 96354.6985373394, 96354.6985373394, 0, 96354.6985373394, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (89, 2, 'contact_loss_events', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (90, 2, 'contact_loss_duration', 'wheelset_2', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (91, 2, 'wheel_rail_force_quantile', 'wheelset_3', 'N', 104572.7100259334, 104572.7100259334, 104572.7100259334, 104572.7100259334, 0, 104572.7100259334, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (92, 2, 'wheel_rail_force_20hz_quantile', 'wheelset_3', 'N', 103232.58187375434, 103232.58187375434, 103232.58187375434, 103232.58187375434, 0, 103232.58187375434, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (93, 2, 'contact_loss_events', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (94, 2, 'contact_loss_duration', 'wheelset_3', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (95, 2, 'wheel_rail_force_quantile', 'wheelset_4', 'N', 102171.18690913617, 102171.18690913617, 102171.18690913617, 102171.18690913617, 0, 102171.18690913617, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (96, 2, 'wheel_rail_force_20hz_quantile', 'wheelset_4', 'N', 83442.66807661935, 83442.66807661935, 83442.66807661935, 83442.66807661935, 0, 83442.66807661935, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (97, 2, 'contact_loss_events', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (98, 2, 'contact_loss_duration', 'wheelset_4', 's', 0, 0, 0, 0, 0, 0, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (99, 2, 'sperling_index', 'car_body', '1', 0.2571389422438466, 0.2571389422438466, 0.2571389422438466, 0.2571389422438466, 0, 0.2571389422438466, 0.0001, 25.008333333333336);
INSERT INTO public.peak VALUES (100, 3, 'wheel_rail_force', 'wheelset_1', 'N', 73161.58668966548, 73161.58668966548, 64282.79261104147, 68892.87987980561, 1499.5567575981113, 68909.19799709311, 0.007766808510638299, 21.37393617021277);
INSERT INTO public.peak VALUES (101, 3, 'wheel_rail_force', 'wheelset_2', 'N', 73183.4339423405, 73183.4339423405, 65396.703670950075, 68733.45028111566, 1531.0180440310717, 68750.49966216787, 0.044310638297872344, 23.911702127659574);
INSERT INTO public.peak VALUES (102, 3, 'wheel_rail_force', 'wheelset_3', 'N', 72975.31871892673, 72975.31871892673, 64206.95076358969, 68594.14480543742, 2170.7615602344476, 68628.48466446502, 0.10853617021276597, 28.371808510638303);
INSERT INTO public.peak VALUES (103, 3, 'wheel_rail_force', 'wheelset_4', 'N', 73208.51984301223, 73208.51984301223, 64045.89364648315, 68757.52535460376, 2253.787049835498, 68794.45362058618, 0.02230468085106383, 22.383510638297874);
INSERT INTO public.peak VALUES (104, 3, 'rail_displacement', 'wheelset_1', 'm', 0.0009736391464364235, 0.0009736391464364235, 0.0008718617017678672, 0.0009228504345578152, 2.0334640714128497e-05, 0.0009230744402140712, 0.013044255319148938, 21.740425531914894);
INSERT INTO public.peak VALUES (105, 3, 'rail_acceleration', 'wheelset_1', 'm/s^2', 12.957793916456524, -7.124255860561073, -12.957793916456524, -9.54060526169467, 1.211276245794605, 9.617189761208953, 0.008364255319148937, 21.415425531914895);
INSERT INTO public.peak VALUES (106, 3, 'rail_acceleration_moving_frame', 'wheelset_1', 'm/s^2', 1.7769069867151124, 1.2513753836279609, -1.7769069867151124, -0.04933469708782792, 0.4832681725768219, 0.4857798256025961, 0.010156595744680853, 21.539893617021278);
INSERT INTO public.peak VALUES (107, 3, 'slab_displacement', 'wheelset_1', 'm', 0.0004721777602677686, 0.0004721777602677686, 0.00041396104033936256, 0.0004406424565080615, 1.2452791182547066e-05, 0.00044081838265400754, 0.015234893617021279, 21.892553191489363);
INSERT INTO public.peak VALUES (108, 3, 'slab_acceleration', 'wheelset_1', 'm/s^2', 1.541341161892789, 0.4353030474097097, -1.541341161892789, -0.605273705645985, 0.3740233295523476, 0.7115122696031647, 0.019417021276595746, 22.182978723404258);
INSERT INTO public.peak VALUES (109, 3, 'base_displacement', 'wheelset_1', 'm', 0.00043371733838233503, 0.00043371733838233503, 0.00037733705491832715, 0.0004035988953597779, 1.180240976621982e-05, 0.0004037714269384632, 0.01463744680851064, 21.851063829787236);
INSERT INTO public.peak VALUES (110, 3, 'base_acceleration', 'wheelset_1', 'm/s^2', 1.3711864406850842, 0.8066020413360213, -1.3711864406850842, -0.3945170358998164, 0.4094988047920671, 0.5686237444403007, 0.02101021276595745, 22.2936170212766);
INSERT INTO public.peak VALUES (111, 3, 'car_body_acceleration', 'car_body', 'm/s^2', 0.02816604382611287, 0.02274747405378698, -0.02816604382611287, -0.0015056706472013344, 0.014315989412274743, 0.014394950397629239, 0.0668144680851064, 25.474468085106388);
INSERT INTO public.peak VALUES (112, 3, 'bogie_acceleration', 'bogie_1', 'm/s^2', 0.6814356383590912, 0.4770873203030686, -0.6814356383590912, -0.06197381812932484, 0.2786564744757696, 0.28546485755831985, 0.05466638297872341, 24.63085106382979);
INSERT INTO public.peak VALUES (113, 3, 'bogie_acceleration', 'bogie_2', 'm/s^2', 0.7280822503452302, 0.5403448061625445, -0.7280822503452302, 0.00257775742148778, 0.2934022143442129, 0.2934135378870775, 0.15682978723404256, 31.725531914893622);
INSERT INTO public.peak VALUES (114, 3, 'wheelset_acceleration', 'wheelset_1', 'm/s^2', 3.415488295334066, 3.225718820577062, -3.415488295334066, -0.08262115719110376, 1.121993560473032, 1.1250314686081224, 0.007667234042553192, 21.367021276595747);
INSERT INTO public.peak VALUES (115, 3, 'wheelset_acceleration', 'wheelset_2', 'm/s^2', 3.6061324237844703, 2.220545574923443, -3.6061324237844703, -0.06809089727777703, 1.1055160723218473, 1.1076110131512853, 0.04401191489361703, 23.890957446808514);
INSERT INTO public.peak VALUES (116, 3, 'wheelset_acceleration', 'wheelset_3', 'm/s^2', 3.729369634422218, 3.729369634422218, -3.1420267184094675, 0.0544637181924501, 1.6077768552176734, 1.6086990746478904, 0.13183659574468087, 29.989893617021277);
INSERT INTO public.peak VALUES (117, 3, 'wheelset_acceleration', 'wheelset_4', 'm/s^2', 3.3836038233525128, 3.3836038233525128, -2.999706811425663, -0.0477962875322239, 1.6319257478983595, 1.6326255332302881, 0.11132425531914895, 28.565425531914897);
INSERT INTO public.peak VALUES (118, 3, 'wheel_rail_force_20hz', 'wheelset_1', 'N', 70748.50030835727, 70748.50030835727, 64343.45250388545, 68830.56346854904, 1124.7820137849012, 68839.7530644648, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (119, 3, 'wheel_unloading', 'wheelset_1', '1', 0.06388826836986355, 0.06388826836986355, -0.06540828148631829, -0.0032456659357157987, 0.021837145152149576, 0.022077030048498723, 0.20004510638297873, 34.72659574468086);
INSERT INTO public.peak VALUES (120, 3, 'contact_loss', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (121, 3, 'wheel_rail_force_20hz', 'wheelset_2', 'N', 70490.2639737254, 70490.2639737254, 67043.33178245251, 68668.1823445093, 987.8984835324238, 68675.28820407341, 0.04869191489361702, 24.215957446808513);
INSERT INTO public.peak VALUES (122, 3, 'wheel_unloading', 'wheelset_2', '1', 0.04766705008082022, 0.04766705008082022, -0.06572642991612791, -0.0009239883663266957, 0.0222952969860357, 0.022314435287424137, 0.021508085106382982, 22.328191489361707);
INSERT INTO public.peak VALUES (123, 3, 'contact_loss', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (124, 3, 'wheel_rail_force_20hz', 'wheelset_3', 'N', 71520.15394907573, 71520.15394907573, 65847.81023084356, 68571.66462510795, 1617.3003323471655, 68590.73443128665, 0.10873531914893618, 28.38563829787234);
INSERT INTO public.peak VALUES (125, 3, 'wheel_unloading', 'wheelset_3', '1', 0.06499270768035986, 0.06499270768035986, -0.06269577281093248, 0.001104633676460869, 0.03161149789186614, 0.031630792189362385, 0.07537787234042553, 26.069148936170215);
INSERT INTO public.peak VALUES (126, 3, 'contact_loss', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (127, 3, 'wheel_rail_force_20hz', 'wheelset_4', 'N', 71410.62860210081, 71410.62860210081, 65861.4082181129, 68716.54845929144, 1654.0658764466443, 68736.45296406976, 0.14508000000000001, 30.909574468085108);
INSERT INTO public.peak VALUES (128, 3, 'wheel_unloading', 'wheelset_4', '1', 0.0673380858237491, 0.0673380858237491, -0.06609174083314731, -0.0012745792136851187, 0.03282054827196007, 0.03284528795800121, 0.11202127659574469, 28.613829787234046);
INSERT INTO public.peak VALUES (129, 3, 'contact_loss', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (130, 3, 'car_body_acceleration_comfort', 'car_body', 'm/s^2', 0.018269951691939915, 0.018269951691939915, -0.01127232614765285, 0.0027309802196338663, 0.009255179548028658, 0.009649694369578727, 0.13830893617021278, 30.43936170212766);
INSERT INTO public.peak VALUES (131, 3, 'wheel_rail_force_quantile', 'wheelset_1', 'N', 73151.4303352336, 73151.4303352336, 73151.4303352336, 73151.4303352336, 0, 73151.4303352336, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (132, 3, 'wheel_rail_force_20hz_quantile', 'wheelset_1', 'N', 70747.27663616189, 70747.27663616189, 70747.27663616189, 70747.27663616189, 0, 70747.27663616189, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (133, 3, 'contact_loss_events', 'wheelset_1', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (134, 3, 'contact_loss_duration', 'wheelset_1', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (135, 3, 'wheel_rail_force_quantile', 'wheelset_2', 'N', 73174.85788359286, 73174.85788359286, 73174.85788359286, 73174.85788359286, 0, 73174.85788359286, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (136, 3, 'wheel_rail_force_20hz_quantile', 'wheelset_2', 'N', 70490.00689788356, 70490.00689788356, 70490.00689788356, 70490.00689788356, 0, 70490.00689788356, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (137, 3, 'contact_loss_events', 'wheelset_2', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (138, 3, 'contact_loss_duration', 'wheelset_2', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (139, 3, 'wheel_rail_force_quantile', 'wheelset_3', 'N', 72963.32935800412, 72963.32935800412, 72963.32935800412, 72963.32935800412, 0, 72963.32935800412, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (140, 3, 'wheel_rail_force_20hz_quantile', 'wheelset_3', 'N', 71519.60071396643, 71519.60071396643, 71519.60071396643, 71519.60071396643, 0, 71519.60071396643, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (141, 3, 'contact_loss_events', 'wheelset_3', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (142, 3, 'contact_loss_duration', 'wheelset_3', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (143, 3, 'wheel_rail_force_quantile', 'wheelset_4', 'N', 73203.29217954431, 73203.29217954431, 73203.29217954431, 73203.29217954431, 0, 73203.29217954431, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (144, 3, 'wheel_rail_force_20hz_quantile', 'wheelset_4', 'N', 71410.20538535682, 71410.20538535682, 71410.20538535682, 71410.20538535682, 0, 71410.20538535682, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (145, 3, 'contact_loss_events', 'wheelset_4', '1', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (146, 3, 'contact_loss_duration', 'wheelset_4', 's', 0, 0, 0, 0, 0, 0, 9.95744680851064e-05, 20.841489361702127);
INSERT INTO public.peak VALUES (147, 3, 'sperling_index', 'car_body', '1', 0.9234412769261161, 0.9234412769261161, 0.9234412769261161, 0.9234412769261161, 0, 0.9234412769261161, 9.95744680851064e-05, 20.841489361702127);


--
-- Data for Name: study; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.study VALUES ('6807b42aa19a44e280ad3dfcaeb28fc2', 'Both slabs', '{"line": "test"}', 0, true, '{"track": {"pad_stiffness_n_per_m": 50000000.0}, "numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "Both slabs", "labels": {"line": "test"}, "sweep": {"kind": "product", "speed_kmh": [300.0], "slab": ["continuous", "discontinuous"], "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}}, "keep_history": true}', 0, 1795340190.644, 1795340214.413, 1795340220.199, NULL);
INSERT INTO public.study VALUES ('879c27dd374647edbf3ff89ad636c339', 'A spectrum', '{}', 0, false, '{"numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "A spectrum", "sweep": {"kind": "product", "speed_kmh": [250.0], "irregularity": {"kind": "spectrum", "percentile": [25.0], "wavelength_band_m": [{"min": 2.0, "max": 30.0}], "seed": 7}}}', 0, 1795340220.301, 1795340220.333, 1795340221.532, NULL);
INSERT INTO public.study VALUES ('c6d81aba110d4ac9a86c3ae993d2f911', 'Queued when the release ended', '{}', 0, false, '{"numerics": {"track_length_m": 90.0, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}, "name": "Queued when the release ended", "sweep": {"kind": "product", "speed_kmh": [200.0], "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}}}', 0, 1795340236.471, NULL, NULL, NULL);


--
-- Data for Name: study_case; Type: TABLE DATA; Schema: public; Owner: -
--

INSERT INTO public.study_case VALUES ('6807b42aa19a44e280ad3dfcaeb28fc2', 1, 0);
INSERT INTO public.study_case VALUES ('6807b42aa19a44e280ad3dfcaeb28fc2', 2, 1);
INSERT INTO public.study_case VALUES ('879c27dd374647edbf3ff89ad636c339', 3, 0);
INSERT INTO public.study_case VALUES ('c6d81aba110d4ac9a86c3ae993d2f911', 4, 0);


--
-- Name: case_id_seq; Type: SEQUENCE SET; Schema: public; Owner: -
--

SELECT pg_catalog.setval('public.case_id_seq', 4, true);


--
-- Name: event_id_seq; Type: SEQUENCE SET; Schema: public; Owner: -
--

SELECT pg_catalog.setval('public.event_id_seq', 12, true);


--
-- Name: peak_id_seq; Type: SEQUENCE SET; Schema: public; Owner: -
--

SELECT pg_catalog.setval('public.peak_id_seq', 147, true);


--
-- Name: alembic_version alembic_version_pkc; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.alembic_version
    ADD CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num);


--
-- Name: case pk_case; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public."case"
    ADD CONSTRAINT pk_case PRIMARY KEY (id);


--
-- Name: event pk_event; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.event
    ADD CONSTRAINT pk_event PRIMARY KEY (id);


--
-- Name: history pk_history; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.history
    ADD CONSTRAINT pk_history PRIMARY KEY (case_id);


--
-- Name: idempotency_key pk_idempotency_key; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.idempotency_key
    ADD CONSTRAINT pk_idempotency_key PRIMARY KEY (key);


--
-- Name: peak pk_peak; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.peak
    ADD CONSTRAINT pk_peak PRIMARY KEY (id);


--
-- Name: study pk_study; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study
    ADD CONSTRAINT pk_study PRIMARY KEY (id);


--
-- Name: study_case pk_study_case; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_case
    ADD CONSTRAINT pk_study_case PRIMARY KEY (study_id, case_id);


--
-- Name: case uq_case_digest_solver_version; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public."case"
    ADD CONSTRAINT uq_case_digest_solver_version UNIQUE (digest, solver_version);


--
-- Name: peak uq_peak_case_id_quantity_position; Type: CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.peak
    ADD CONSTRAINT uq_peak_case_id_quantity_position UNIQUE (case_id, quantity, "position");


--
-- Name: ix_case_queue; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_case_queue ON public."case" USING btree (state, priority DESC, id);


--
-- Name: ix_event_study_id_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_event_study_id_id ON public.event USING btree (study_id, id);


--
-- Name: ix_idempotency_key_created_at; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_idempotency_key_created_at ON public.idempotency_key USING btree (created_at);


--
-- Name: ix_peak_quantity_peak; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_peak_quantity_peak ON public.peak USING btree (quantity, peak);


--
-- Name: ix_study_case_case_id; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_study_case_case_id ON public.study_case USING btree (case_id);


--
-- Name: ix_study_created_at; Type: INDEX; Schema: public; Owner: -
--

CREATE INDEX ix_study_created_at ON public.study USING btree (created_at);


--
-- Name: event fk_event_study_id_study; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.event
    ADD CONSTRAINT fk_event_study_id_study FOREIGN KEY (study_id) REFERENCES public.study(id) ON DELETE CASCADE;


--
-- Name: history fk_history_case_id_case; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.history
    ADD CONSTRAINT fk_history_case_id_case FOREIGN KEY (case_id) REFERENCES public."case"(id) ON DELETE CASCADE;


--
-- Name: peak fk_peak_case_id_case; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.peak
    ADD CONSTRAINT fk_peak_case_id_case FOREIGN KEY (case_id) REFERENCES public."case"(id) ON DELETE CASCADE;


--
-- Name: study_case fk_study_case_case_id_case; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_case
    ADD CONSTRAINT fk_study_case_case_id_case FOREIGN KEY (case_id) REFERENCES public."case"(id);


--
-- Name: study_case fk_study_case_study_id_study; Type: FK CONSTRAINT; Schema: public; Owner: -
--

ALTER TABLE ONLY public.study_case
    ADD CONSTRAINT fk_study_case_study_id_study FOREIGN KEY (study_id) REFERENCES public.study(id) ON DELETE CASCADE;


--
-- PostgreSQL database dump complete
--

\unrestrict bxndQLSEP72JbX5cuKvcelqfT5qDmwbbzTxzXBP91xx9T58AChnJYaIT4cMtGsQ

